// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_HPP
#define OPENCV_GCPW_HPP

/**
@defgroup gcpw Generalized Content-Preserving Warps for image stitching

Aligns overlapping photographs by a mesh and a local affine colour model of each image, estimated together
@cite chen2018gcpw.

Coordinates: a pixel centre has integer coordinates. The *canvas* is the plane of the panorama. Estimation happens at the working
resolution (Params::workMegapix), rendering at full resolution.

@code
cv::Mat panorama;
if (cv::gcpw::stitchPair(cv::imread("a.jpg"), cv::imread("b.jpg"), panorama)) // two photographs
    cv::imwrite("panorama.png", panorama);

const cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create(); // several photographs
cv::gcpw::attach(stitcher);
stitcher->stitch(photographs, panorama);
@endcode

| header | holds |
|---|---|
| params.hpp | Method, Params: the parameters |
| alignment.hpp | Alignment: meshes, colours, report |
| aligner.hpp | Aligner: any number of roughly aligned images |
| pair.hpp | alignPair, stitchPair: two photographs |
| pair_matches.hpp | PairMatches: what two photographs have in common, found once |
| cameras.hpp | estimateCameras: cameras and projection of a set of photographs, where cv::Stitcher gives up |
| stitcher.hpp | attach: GCPW inside cv::Stitcher |
| rig.hpp | Rig: an alignment with its cameras, for many frames |
| frame_composer.hpp | FrameComposer: panoramas of a rig's frames at the cost of remapping |
| warper.hpp | GcpwWarper: the meshes of a rig behind any warper |
| rotation_warper.hpp | GcpwRotationWarper: what GcpwWarper makes; PyGcpwWarper: the same for Python |
| compensator.hpp | GcpwCompensator: local colours |
| seam_finder.hpp | GcpwSeamFinder: cuts that leave things whole |
*/

#include "opencv2/gcpw/aligner.hpp"
#include "opencv2/gcpw/alignment.hpp"
#include "opencv2/gcpw/cameras.hpp"
#include "opencv2/gcpw/compensator.hpp"
#include "opencv2/gcpw/frame_composer.hpp"
#include "opencv2/gcpw/pair.hpp"
#include "opencv2/gcpw/pair_matches.hpp"
#include "opencv2/gcpw/params.hpp"
#include "opencv2/gcpw/rig.hpp"
#include "opencv2/gcpw/rotation_warper.hpp"
#include "opencv2/gcpw/seam_finder.hpp"
#include "opencv2/gcpw/stitcher.hpp"
#include "opencv2/gcpw/warper.hpp"

#endif

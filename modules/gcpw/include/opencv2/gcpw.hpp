// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_HPP
#define OPENCV_GCPW_HPP

/**
@defgroup gcpw Generalized Content-Preserving Warps for image stitching

Aligns overlapping photographs by a mesh and a local affine colour model of each image, estimated together
@cite chen2018gcpw.

Coordinates: a pixel centre has integer coordinates. The *rest frame* of an image is its own pixels; the *canvas* is the
panorama. Estimation happens at the working resolution (Params::workMegapix), rendering at full resolution.

| header | holds |
|---|---|
| params.hpp | Method, Params: every constant |
| alignment.hpp | Alignment: meshes, colours, report |
| aligner.hpp | Aligner: any number of roughly aligned images |
| pair.hpp | alignPair, stitchPair: two photographs |
| pair_matches.hpp | PairMatches: what two photographs have in common, found once |
| stitcher.hpp | attach: GCPW inside cv::Stitcher |
| rig.hpp | Rig: an alignment with its cameras, for many frames |
| warper.hpp | GcpwWarper: the mesh behind any base warper |
| compensator.hpp | GcpwCompensator: local colours |
*/

#include "opencv2/gcpw/aligner.hpp"
#include "opencv2/gcpw/alignment.hpp"
#include "opencv2/gcpw/compensator.hpp"
#include "opencv2/gcpw/pair.hpp"
#include "opencv2/gcpw/pair_matches.hpp"
#include "opencv2/gcpw/params.hpp"
#include "opencv2/gcpw/rig.hpp"
#include "opencv2/gcpw/stitcher.hpp"
#include "opencv2/gcpw/warper.hpp"

#endif

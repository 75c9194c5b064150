// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_JOB_HPP
#define GCPW_APPS_STITCH_JOB_HPP

#include <string>
#include <vector>
#include <opencv2/gcpw/params.hpp>
#include "common/command_line.hpp"
#include "common/encode_picture.hpp"
#include "stitch/setup.hpp"

/// Everything one run of gcpw_stitch is asked to do.
struct StitchJob
{
    std::vector<std::string> paths; ///< of the photographs, lists and folders expanded
    std::string output = "result.png";
    std::string dump;
    std::string report; ///< a folder for a page, or a file ending in .json
    std::string save_model;
    std::string load_model;
    std::string save_graph;
    std::string timelapse; ///< as_is, crop or empty
    std::string crop = "auto";
    std::string panoramas = "all"; ///< or largest
    std::string tiled = "auto";    ///< yes, no: without holding photographs and picture in memory
    std::string tiles;             ///< rows of tiles to be made, none or empty for all; see TileRows
    bool join = false;             ///< the paths are files of --tiles
    bool gcpw = true;
    bool plain_colors = false; ///< exposures as --expos_comp says, instead of GCPW's colours
    bool skip_bad = false;
    bool preview = false;
    StitchSetup setup;
    PictureFormat format;
    cv::gcpw::Params params;

    /// The picture of the n-th panorama, from 1 on: pano.png, pano-2.png, ..
    std::string outputOf(int panorama) const;

    /// The job of a further panorama, from 2 on: its picture alone.
    StitchJob further(int panorama) const;

    /// Why the picture cannot be made in tiles; empty if it can.
    std::string obstacleToTiles() const;

    /// The frame of a time lapse that a photograph gives, beside the output.
    std::string frameOf(const std::string& photograph) const;
};

/// The options of gcpw_stitch. Declares them in its constructor; job() once they are parsed.
class StitchOptions
{
public:
    StitchOptions();

    CommandLine& line() { return line_; }

    /// Checks everything that can be checked before any work. @throws WrongUse, FileTrouble
    StitchJob job(Console& console);

private:
    void declareOutputs();
    void declareEstimation();
    void declareComposition();
    void makeSmall();
    void checkValues() const;
    void checkTiles() const;
    void planOutputs(Console& console) const;

    CommandLine line_;
    StitchJob job_;
    std::vector<std::string> arguments_;
    std::vector<std::string> lists_;
    std::string method_ = "gcpw";
    std::string settings_;
    std::string try_cuda_ = "no";
    int reference_ = -1;
};

#endif

// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PROBLEM_BUILDER_HPP
#define OPENCV_GCPW_PROBLEM_BUILDER_HPP

#include <vector>
#include "api/rough_start.hpp"
#include "api/work_image.hpp"
#include "energy/problem.hpp"
#include "opencv2/gcpw/aligner.hpp"
#include "overlap/outside_distance.hpp"
#include "registration/pair_matcher.hpp"
#include "registration/rough_alignment.hpp"

namespace cv
{
namespace gcpw
{

/** @brief From images to the estimation's Problem and its result: the one way of alignPair() and Aligner.

Call startFrom() or startFromHomography() once, the others as needed, and align() last. Where a step fails or is cancelled the report
says so, and the steps after it do nothing. Arguments must have been checked. */
class ProblemBuilder
{
public:
    /** @param images of a type that toPhotograph() takes  @param masks CV_8UC1 of the same sizes; an empty one, or none
    at all, means everywhere  @param params, progress outlive the builder */
    ProblemBuilder(const std::vector<Mat>& images, const std::vector<Mat>& masks, ScaleRule rule, const Params& params,
                   const Progress& progress);

    /** @brief Stage "features": keypoints and segments of every image, found at up to Params::featureMegapix.
    @param known keypoints of images, as Aligner::align() has them */
    void findFeatures(const std::vector<KnownKeypoints>& known = std::vector<KnownKeypoints>());

    /// First step of stage "homography": the start of two images from the features of both.
    void startFromHomography();

    void startFrom(const RoughStart& start);

    /** @brief Stage "homography": the matches of every pair.
    @param kinds which matches to look for
    @param known correspondences; if there are any, even for other pairs, they are verified and nothing is looked for */
    void findMatches(MatchKinds kinds, const std::vector<Correspondences>& known = std::vector<Correspondences>());

    /** @brief Part of stage "features": what is to stay straight in each image that moves, and of its borders what no other shows.

    After the start is known.
    @param known one entry for each image; if there is none, line segments are looked for at the working resolution, and an image
    without a mask ends at its borders */
    void keepStraight(const std::vector<KnownLines>& known = std::vector<KnownLines>());

    /** @brief What no other image shows is to keep its size and direction.

    For images whose rough alignment is sound beyond the overlap, as that of cameras is; a homography fitted to one overlap is not. */
    void keepOutside();

    /// Matches of the first pair, taken as verified.
    void setMatches(const MatchSet& matches);

    /// Stage "align". No images in the result if there was no start; else they lie at the start if any step failed.
    Alignment align();

    const std::vector<WorkImage>& images() const { return images_; }
    const RoughStart& start() const { return start_; }
    const Problem& problem() const { return problem_; }
    const Report& report() const { return report_; }
    Report& report() { return report_; } ///< for what was found before; align() adds to its total time

private:
    bool goOn(const char* stage, double share);
    Photograph shownAt(size_t i, double megapix) const;
    Size2d toReference(size_t i, const Photograph& shown) const;
    Keypoints findKeypoints(size_t i, double megapix) const;
    RoughAlignment alignFeatures() const;
    std::vector<Neighbour> neighboursOf(int image) const;
    void keepBorders(const std::vector<Curve>& borders, int image);
    bool failed() const { return report_.status != Status::OK; }
    MatchSet verified(const std::vector<Correspondences>& known, const ProblemPair& pair) const;

    const Params& params_;
    const Progress& progress_;
    int64 begin_;
    std::vector<Photograph> full_;
    std::vector<WorkImage> images_;
    std::vector<Features> features_;
    RoughStart start_;
    int homography_steps_ = 0; ///< of its stage, done before pairs are matched
    Problem problem_;
    Report report_;
};

} // namespace gcpw
} // namespace cv

#endif

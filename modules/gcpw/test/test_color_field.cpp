// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <limits>
#include <opencv2/imgproc.hpp>
#include "rendering/color_field.hpp"
#include "scene.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

typedef Vec<float, 6> GridValue;

/// 3 x 4 quads. Gains are linear in the position of the quad's centre, biases in another direction.
Mat linearGrid()
{
    Mat grid(3, 4, CV_32FC(6));
    for (int row = 0; row < grid.rows; ++row)
        for (int col = 0; col < grid.cols; ++col)
            for (int c = 0; c < 3; ++c)
            {
                grid.at<GridValue>(row, col)[c] = static_cast<float>(1 + 0.1 * col - 0.02 * row + 0.1 * c);
                grid.at<GridValue>(row, col)[3 + c] = static_cast<float>(0.03 * row - 0.02 * c);
            }
    return grid;
}

Mat oneQuad(const GridValue& value)
{
    Mat grid(1, 1, CV_32FC(6));
    grid.at<GridValue>(0, 0) = value;
    return grid;
}

double distance(const ColorField::ColorMap& a, const ColorField::ColorMap& b)
{
    return cv::norm(a - b, NORM_INF);
}

/// What the definition says, pixel by pixel: the grid between its centres, on YCrCb floats.
Mat byDefinition(const Mat& picture, const Mat& grid, const GridPosition& position)
{
    Mat pixels;
    picture.convertTo(pixels, CV_32F, 1 / 255.0);
    cvtColor(pixels, pixels, COLOR_BGR2YCrCb);
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x)
        {
            const Point2f at = position(Point(x, y));
            const float gx = std::min(std::max(at.x - 0.5F, 0.0F), grid.cols - 1.0F);
            const float gy = std::min(std::max(at.y - 0.5F, 0.0F), grid.rows - 1.0F);
            GridValue value = GridValue::all(0);
            for (int row = 0; row < grid.rows; ++row)
                for (int col = 0; col < grid.cols; ++col)
                    value += grid.at<GridValue>(row, col) * (std::max(0.0F, 1 - std::abs(gx - col)) * std::max(0.0F, 1 - std::abs(gy - row)));
            Vec3f& pixel = pixels.at<Vec3f>(y, x);
            for (int c = 0; c < 3; ++c)
                pixel[c] = value[c] * pixel[c] + value[3 + c];
        }
    cvtColor(pixels, pixels, COLOR_YCrCb2BGR);
    Mat result;
    pixels.convertTo(result, CV_8U, 255);
    return result;
}

Mat texturedPicture(Size size)
{
    const Texture texture(7);
    Mat picture(size, CV_8UC3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            picture.at<Vec3b>(y, x) = Vec3b(texture.at(Point2d(x, y)) * 255.0);
    return picture;
}

/// A grid whose quads know nothing of each other: it bends as much as it can at every centre.
Mat restlessGrid(int rows, int cols)
{
    RNG rng = seeded(5);
    Mat grid(rows, cols, CV_32FC(6));
    for (int row = 0; row < rows; ++row)
        for (int col = 0; col < cols; ++col)
            for (int c = 0; c < 3; ++c)
            {
                grid.at<GridValue>(row, col)[c] = rng.uniform(0.8F, 1.2F);
                grid.at<GridValue>(row, col)[3 + c] = rng.uniform(-0.05F, 0.05F);
            }
    return grid;
}

/// The grid turned, stretched and shifted over the picture, and a little beyond.
Point2f turned(Point p)
{
    const float x = static_cast<float>(p.x);
    const float y = static_cast<float>(p.y);
    return {0.09F * x - 0.02F * y + 0.2F, 0.03F * x + 0.1F * y - 0.7F};
}

/// Rows run along the grid's: between two centres the field is linear on them.
Point2f upright(Point p)
{
    return {0.093F * static_cast<float>(p.x) + 0.2F, 0.11F * static_cast<float>(p.y) - 0.7F};
}

TEST(Gcpw_ColorField, a_grid_of_ones_changes_no_pixel)
{
    const Mat ones = oneQuad(GridValue(1, 1, 1, 0, 0, 0));
    for (const int channels : {1, 3})
    {
        Mat picture = texturedPicture(Size(61, 43));
        if (channels == 1)
            extractChannel(picture, picture, 1);
        const Mat before = picture.clone();
        ColorField(ones).apply(picture, Mat(), turned);
        EXPECT_EQ(cv::norm(picture, before, NORM_INF), 0) << channels;
    }
}

TEST(Gcpw_ColorField, quad_centres_have_the_quads_own_color)
{
    const Mat grid = linearGrid();
    const ColorField field(grid);
    for (int row = 0; row < grid.rows; ++row)
        for (int col = 0; col < grid.cols; ++col)
        {
            const ColorField own(oneQuad(grid.at<GridValue>(row, col)));
            EXPECT_LE(distance(field.at(Point2f(col + 0.5F, row + 0.5F)), own.at(Point2f())), 1e-5) << row << col;
        }
}

TEST(Gcpw_ColorField, between_centres_it_is_bilinear)
{
    const ColorField field(linearGrid());
    RNG rng = seeded(1);
    for (int i = 0; i < 200; ++i)
    {
        const double col = rng.uniform(0.0, 3.0);
        const double row = rng.uniform(0.0, 2.0);
        GridValue expected;
        for (int c = 0; c < 3; ++c)
        {
            expected[c] = static_cast<float>(1 + 0.1 * col - 0.02 * row + 0.1 * c);
            expected[3 + c] = static_cast<float>(0.03 * row - 0.02 * c);
        }
        const Point2f at(static_cast<float>(col + 0.5), static_cast<float>(row + 0.5));
        EXPECT_LE(distance(field.at(at), ColorField(oneQuad(expected)).at(at)), 1e-4);
    }
}

TEST(Gcpw_ColorField, beyond_the_outer_centres_it_is_constant)
{
    const ColorField field(linearGrid());
    const auto same = [&](Point2f p, Point2f q) { EXPECT_LE(distance(field.at(p), field.at(q)), 1e-6) << p << q; };
    same(Point2f(0, 1.5F), Point2f(0.5F, 1.5F));
    same(Point2f(4, 1.5F), Point2f(3.5F, 1.5F));
    same(Point2f(1.5F, -100), Point2f(1.5F, 0.5F));
    same(Point2f(1.5F, 1000), Point2f(1.5F, 2.5F));
    same(Point2f(-1, -1), Point2f(0.5F, 0.5F));
    same(Point2f(std::numeric_limits<float>::quiet_NaN(), 1.5F), Point2f(0, 1.5F));
}

TEST(Gcpw_ColorField, a_single_quad_is_one_color_everywhere)
{
    const ColorField field(oneQuad(GridValue(0.7F, 1.1F, 1, 0.1F, 0, 0)));
    for (const Point2f& p : {Point2f(0, 0), Point2f(1, 0.4F), Point2f(0.5F, 0.5F), Point2f(7, -3)})
        EXPECT_EQ(distance(field.at(p), field.at(Point2f())), 0) << p;
}

TEST(Gcpw_ColorField, a_picture_has_the_colours_of_the_definition)
{
    const Mat before = texturedPicture(Size(157, 93));
    for (const Size size : {Size(1, 1), Size(2, 1), Size(6, 5), Size(16, 12)})
    {
        const Mat grid = restlessGrid(size.height, size.width);
        for (const GridPosition& position : {GridPosition(turned), GridPosition(upright)})
        {
            Mat picture = before.clone();
            ColorField(grid).apply(picture, Mat(), position);
            const Mat expected = byDefinition(before, grid, position);
            EXPECT_LE(cv::norm(picture, expected, NORM_INF), 1) << size;
            EXPECT_LE(cv::norm(picture, expected, NORM_L1) / (3.0 * static_cast<double>(picture.total())), 0.05) << size;
            EXPECT_GT(cv::norm(picture, before, NORM_INF), 5) << size;
        }
    }
}

TEST(Gcpw_ColorField, a_picture_of_16_bits_has_the_colours_of_one_of_8_between_its_steps)
{
    const Mat grid = linearGrid();
    Mat bytes(30, 40, CV_8UC3);
    RNG(7).fill(bytes, RNG::UNIFORM, 60, 150); // away from both ends, where each is clipped
    Mat deep;
    bytes.convertTo(deep, CV_16U, 257);
    deep += Scalar::all(100);
    const GridPosition position = [](Point p) { return Point2f(p.x * 0.1F, p.y * 0.1F); };
    ColorField(grid).apply(bytes, Mat(), position);
    ColorField(grid).apply(deep, Mat(), position);
    Mat difference;
    Mat expected;
    bytes.convertTo(expected, CV_32F, 257);
    deep.convertTo(difference, CV_32F);
    difference -= expected;
    // A step of 8 bits is 257; the 100 on top are gained by 1 to 1.5 of each channel of YCrCb.
    EXPECT_GT(cv::mean(difference)[0], 80);
    EXPECT_LT(cv::norm(difference, NORM_INF), 129 + 250);
}

TEST(Gcpw_ColorField, a_gray_picture_has_the_lightness_of_the_gray_colour)
{
    Mat gray;
    cvtColor(texturedPicture(Size(90, 70)), gray, COLOR_BGR2GRAY);
    Mat colored;
    cvtColor(gray, colored, COLOR_GRAY2BGR);
    Mat grid = linearGrid();
    for (int row = 0; row < grid.rows; ++row)
        for (int col = 0; col < grid.cols; ++col)
            for (const int c : {1, 2})
                grid.at<GridValue>(row, col)[c] = 1; // 0.5 is added to Cr and Cb: a gain there would leave 0..255
    const ColorField field(grid);
    field.apply(gray, Mat(), turned);
    field.apply(colored, Mat(), turned);
    cvtColor(colored, colored, COLOR_BGR2GRAY);
    EXPECT_LE(cv::norm(gray, colored, NORM_INF), 1);
}

TEST(Gcpw_ColorField, outside_the_mask_nothing_is_touched_and_nothing_asked)
{
    const Mat before = texturedPicture(Size(120, 80));
    Mat mask = Mat::zeros(before.size(), CV_8UC1);
    RNG rng = seeded(3);
    for (int y = 0; y < mask.rows; ++y) // runs of every length, up to both borders
        for (int x = rng.uniform(0, 12); x < mask.cols; x += rng.uniform(2, 25))
            mask(Rect(x, y, std::min(rng.uniform(1, 20), mask.cols - x), 1)).setTo(255);
    const ColorField field(restlessGrid(8, 10));
    Mat whole = before.clone();
    field.apply(whole, Mat(), turned);
    Mat masked = before.clone();
    field.apply(masked, mask, [&](Point p)
    {
        CV_Assert(mask.at<uchar>(p) != 0);
        return turned(p);
    });
    EXPECT_EQ(cv::norm(masked, before, NORM_INF, mask == 0), 0);
    EXPECT_LE(cv::norm(masked, whole, NORM_INF, mask), 1);
    EXPECT_GT(cv::norm(masked, before, NORM_INF, mask), 5);
}

TEST(Gcpw_ColorField, positions_on_nodes_are_those_asked_for)
{
    const auto exact = [](Point2d p) { return Point2d(0.1 * p.x - 0.02 * p.y, 0.05 * p.y + 0.01 * p.x); };
    for (const Size size : {Size(1, 1), Size(8, 8), Size(37, 16)})
    {
        const GridPosition position = positionOnNodes(size, exact);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                ASSERT_LE(cv::norm(Point2d(position(Point(x, y))) - exact(Point2d(x, y))), 1e-5) << size << Point(x, y);
    }
}

TEST(Gcpw_ColorField, one_thread_and_many_give_the_same_bits)
{
    const ColorField field(restlessGrid(8, 10));
    Mat pictures[2];
    const int threads = getNumThreads();
    for (int i = 0; i < 2; ++i)
    {
        setNumThreads(i == 0 ? std::max(threads, 2) : 1);
        pictures[i] = texturedPicture(Size(120, 80));
        field.apply(pictures[i], Mat(), turned);
    }
    setNumThreads(threads);
    EXPECT_EQ(cv::norm(pictures[0], pictures[1], NORM_INF), 0);
}

TEST(Gcpw_ColorField, what_is_no_picture_or_no_grid_is_refused)
{
    const ColorField field(linearGrid());
    for (const int type : {CV_8UC4, CV_16SC3, CV_32FC1})
    {
        Mat picture(20, 20, type, Scalar::all(1));
        EXPECT_THROW(field.apply(picture, Mat(), turned), cv::Exception) << type;
    }
    EXPECT_THROW(ColorField(Mat(3, 4, CV_32FC(3))), cv::Exception);
}

}} // namespace

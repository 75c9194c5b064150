// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <gtest/gtest.h>
#include "report/html.hpp"

namespace
{

TEST(Report_Html, text_cannot_become_a_tag)
{
    EXPECT_EQ(report::escaped("<a href=\"x\">'&"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;");
    EXPECT_EQ(report::escaped("B\xC3\xA4ume \xE2\x9C\x93"), "B\xC3\xA4ume \xE2\x9C\x93");
    EXPECT_EQ(report::escaped(std::string("a\xFF") + "b\x01"), "a?b?") << "names of files may hold any bytes";
    EXPECT_EQ(report::escaped("cut \xE2\x9C"), "cut ??");
}

TEST(Report_Html, base64_is_that_of_the_rfc)
{
    const auto of = [](const std::string& text)
    { return report::base64(std::vector<uchar>(text.begin(), text.end())); };
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foo"), "Zm9v");
    EXPECT_EQ(of("foobar"), "Zm9vYmFy");
    EXPECT_EQ(report::base64({0xFB, 0xFF, 0x00}), "+/8A");
}

TEST(Report_Html, every_place_of_a_template_is_filled_once_and_values_are_not_looked_through)
{
    EXPECT_EQ(report::filled("<{{a}}, {{b}}, {{a}}>", {{"a", "{{b}}"}, {"b", "2"}}), "<{{b}}, 2, {{b}}>");
    EXPECT_THROW(report::filled("{{a}}", {}), cv::Exception);
    EXPECT_THROW(report::filled("a", {{"a", "1"}}), cv::Exception);
    EXPECT_THROW(report::filled("{{a", {{"a", "1"}}), cv::Exception);
}

TEST(Report_Html, a_picture_is_compressed_until_it_fits)
{
    cv::Mat noise(300, 400, CV_8UC3);
    cv::RNG rng(1);
    rng.fill(noise, cv::RNG::UNIFORM, 0, 256);
    const report::DataUri large = report::jpegUri(noise, 10000);
    const report::DataUri small = report::jpegUri(noise, 60);
    EXPECT_EQ(large.text.find("data:image/jpeg;base64,/9j/"), 0u);
    EXPECT_GT(large.quality, small.quality);
    EXPECT_LT(small.text.size(), 60 * 1000 * 4 / 3 + 100);
    EXPECT_EQ(report::jpegUri(noise, 1).quality, 40) << "less would show nothing";
}

TEST(Report_Html, a_missing_number_is_a_dash)
{
    EXPECT_EQ(report::numberOrDash(1.25, "%.1f"), "1.2");
    EXPECT_EQ(report::numberOrDash(std::nan(""), "%.1f"), "&ndash;");
    EXPECT_EQ(report::change(-0.04), "0.0");
    EXPECT_EQ(report::change(-0.06), "-0.1");
    EXPECT_EQ(report::change(2), "+2.0");
}

} // namespace

// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/viewer.hpp"

#include <opencv2/imgproc.hpp>
#include "report/html.hpp"
#include "report/svg.hpp"

namespace report
{

namespace
{

const int PICTURE_KILOBYTES = 430; ///< six pictures and the rest stay below five megabytes, a third of them for base64
const int MAP_KILOBYTES = 260;

/// One thing to look at.
struct Layer
{
    const char* id;
    const char* name;
    const char* legend;  ///< HTML: what is seen, with the colours
    bool vector = false; ///< lies over the picture
};

const Layer LAYERS[] = {
    {"picture", "Picture", "The finished picture."},
    {"misalignment", "Misalignment",
     "How little overlapping photographs agree, in windows of 15 x 15 px of this page, whatever their light: "
     "<i class=\"scale heat\"></i> from slightly to not at all. Gray: they agree, have no texture, or do not overlap. "
     "Things that moved between the photographs stay coloured."},
    {"mean", "Plain mean", "All photographs averaged without a cut. Whatever does not line up is double."},
    {"lines", "Straight lines",
     "Long straight lines of the photographs: <i class=\"key held\"></i> kept straight, <i class=\"key bent\"></i> "
     "bent by the mesh by "
     "more than 1.5 px.",
     true},
    {"mesh", "Mesh",
     "Each photograph is a mesh of quads that is moved vertex by vertex. Left: as the rough alignment has it.", true},
    {"cuts", "Cuts",
     "Along these lines one photograph ends and the next begins. The numbers are those of the table of photographs.",
     true},
    {"light", "Change of light",
     "What the colour correction adds to each photograph: <i class=\"key lighter\"></i> lighter, <i class=\"key "
     "darker\"></i> darker, "
     "strongest at 30 of 255 gray levels."},
};

std::string image(const char* layer, const cv::Mat& picture, const std::string& alt, int kilobytes)
{
    return cv::format("<img data-show=\"%s\" width=\"%d\" height=\"%d\" draggable=\"false\" alt=\"", layer,
                      picture.cols, picture.rows) +
           escaped(alt) + "\" src=\"" + jpegUri(picture, kilobytes).text + "\">\n";
}

std::string path(const char* kind, const std::string& data)
{
    return data.empty() ? std::string() : "<path class=\"" + std::string(kind) + "\" d=\"" + data + "\"/>";
}

std::string drawing(const char* layer, cv::Size size, const std::string& label, const std::string& content)
{
    return cv::format("<svg data-show=\"%s\" viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"", layer, size.width,
                      size.height) +
           escaped(label) + "\">" + content + "</svg>\n";
}

std::string linesOf(const Picture& picture, const cv::Rect& frame)
{
    std::vector<Path> held;
    std::vector<Path> bent;
    for (const Line& line : picture.lines)
        (line.bent ? bent : held).push_back(line.path);
    return path("held", pathData(held, frame)) + path("bent", pathData(bent, frame));
}

std::string meshesOf(const Picture& picture, const cv::Rect& frame)
{
    const size_t colors = 4; // neighbours are told apart
    std::string content;
    for (size_t k = 0; k < picture.meshes.size(); ++k)
        content += path(cv::format("mesh m%zu", k % colors).c_str(), pathData(picture.meshes[k], frame));
    return content;
}

std::string cutsOf(const Picture& picture, const Page& page, const cv::Rect& frame)
{
    const std::string data = cutData(picture.labels, frame);
    std::string content = path("cut under", data) + path("cut", data);
    const std::vector<cv::Point> places = middles(picture.labels, picture.images.size(), frame);
    for (size_t k = 0; k < page.photographs.size(); ++k)
    {
        const int shown = page.photographs[k].shown;
        if (shown >= 0 && places[static_cast<size_t>(shown)].x >= 0)
            content += cv::format("<text x=\"%d\" y=\"%d\">%zu</text>", places[static_cast<size_t>(shown)].x,
                                  places[static_cast<size_t>(shown)].y, k + 1);
    }
    return content;
}

/// All layers of one picture.
std::string sideOf(const char* side, const std::string& name, const Picture& picture, const Page& page,
                   Misalignment& misalignment)
{
    const cv::Rect& frame = page.frame;
    const cv::Size size = frame.size();
    cv::Mat shown = framed(picture.image, picture.origin, frame);
    clearBeside(picture.images, frame, shown);
    misalignment = misalignmentOf(picture.images, frame);
    const auto map = [&](cv::Mat drawing)
    {
        clearBeside(picture.images, frame, drawing);
        return drawing;
    };
    std::string html = "<div class=\"side " + std::string(side) + "\">\n";
    html += image("picture", shown, "The picture by " + name, PICTURE_KILOBYTES);
    html += image("misalignment", map(drawn(misalignment, shown)),
                  "Map of what is misaligned in the picture by " + name, MAP_KILOBYTES);
    html += image("mean", meanOf(picture.images, frame), "Plain mean of the photographs as " + name + " warps them",
                  MAP_KILOBYTES);
    html += image("light", map(drawnLight(picture, shown, frame)), "Map of what " + name + " makes lighter and darker",
                  MAP_KILOBYTES);
    html += drawing("lines", size, "Straight lines in the picture by " + name, linesOf(picture, frame));
    html += drawing("mesh", size, "Meshes of the picture by " + name, meshesOf(picture, frame));
    html += drawing("cuts", size, "Cuts of the picture by " + name, cutsOf(picture, page, frame));
    html += "<span class=\"name\">" + escaped(name) + "</span>\n</div>\n";
    return html;
}

std::string choices()
{
    std::string html = "<fieldset class=\"layers\"><legend>Show</legend>\n";
    for (const Layer& layer : LAYERS)
        html += std::string("<label><input type=\"radio\" name=\"layer\" value=\"") + layer.id + "\"" +
                (&layer == LAYERS ? " checked" : "") + "> " + layer.name + "</label>\n";
    return html + "</fieldset>\n";
}

std::string legends()
{
    std::string html = "<div class=\"legends\" aria-live=\"polite\">\n";
    for (const Layer& layer : LAYERS)
        html += std::string("<p data-show=\"") + layer.id + "\">" + layer.legend + "</p>\n";
    return html + "</div>\n";
}

} // namespace

Viewer viewerOf(const Page& page)
{
    Viewer viewer;
    const bool compared = !page.before.image.empty();
    std::string sides = sideOf("after", page.method, page.after, page, viewer.after);
    if (compared)
        sides += sideOf("before", page.before_name, page.before, page, viewer.before);
    viewer.html =
        "<div class=\"viewer\" data-layer=\"picture\">\n" + choices() +
        cv::format("<div class=\"window\"><div class=\"stage\" style=\"aspect-ratio: %d / %d; --ratio: %.4f\">\n",
                   page.frame.width, page.frame.height, static_cast<double>(page.frame.width) / page.frame.height) +
        sides + (compared ? "<div class=\"handle\" aria-hidden=\"true\"></div>\n" : "") + "</div></div>\n";
    if (compared)
        viewer.html += "<p class=\"slider\"><label for=\"split\"><span class=\"from\">" + escaped(page.before_name) +
                       "</span> <span class=\"to\">" + escaped(page.method) +
                       "</span></label>\n<input id=\"split\" type=\"range\" min=\"0\" max=\"100\" step=\"0.5\" "
                       "value=\"50\" aria-label=\"Share of the "
                       "picture that shows " +
                       escaped(page.before_name) + "\"></p>\n";
    viewer.html += "<p class=\"zoom\" role=\"group\" aria-label=\"Size\"><button type=\"button\" data-zoom=\"1\" "
                   "aria-pressed=\"true\">Fit</button> "
                   "<button type=\"button\" data-zoom=\"2\" aria-pressed=\"false\">2 &times;</button> "
                   "<button type=\"button\" data-zoom=\"4\" aria-pressed=\"false\">4 &times;</button></p>\n" +
                   legends() + "</div>\n";
    return viewer;
}

} // namespace report

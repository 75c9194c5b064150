// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/steps.hpp"

#include "common/exit_code.hpp"
#include "common/write_file.hpp"

void requireAllOfModel(const StitchJob& job, const std::vector<Photograph>& photographs)
{
    if (!job.load_model.empty() && photographs.size() < job.paths.size())
        throw FileTrouble("a model needs all photographs that it was made of, and some of them cannot be read");
}

void writeGraph(const StitchJob& job, const std::vector<Photograph>& photographs, const MatchLog& log)
{
    if (job.save_graph.empty())
        return;
    std::vector<std::string> names;
    for (const Photograph& photograph : photographs)
        names.push_back(photograph.path);
    writeText(job.save_graph, log.graph(names, job.setup.conf_thresh));
}

void tellDecisions(const Layout& layout, const Console& console)
{
    for (const std::string& decision : layout.decisions)
        console.tell(decision);
}

void tellDropped(const std::string& path, const Console& console)
{
    console.tell("dropped " + path + ": it matches none of the others well enough");
}

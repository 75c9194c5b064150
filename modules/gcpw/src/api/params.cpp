// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/params.hpp"

#include <cmath>
#include <sstream>

namespace cv
{
namespace gcpw
{

namespace
{

/// One numeric member: its name, where it is and which values it may have.
struct Field
{
    const char* name;
    int Params::*integer;
    double Params::*real;
    double low;
    double high;
    bool low_included;
};

const double HEAVIEST = 1e9; ///< of a weight: far beyond any use, and sums of squares stay exact enough to solve
const double LONGEST = 1e9;  ///< px of a canvas that repeats: still fits an int
const double LARGEST = 1e6;  ///< of a length or ratio: as good as endless

const Field FIELDS[] = {
    {"meshCols", &Params::meshCols, nullptr, 2, 256, true},
    {"meshRows", &Params::meshRows, nullptr, 2, 256, true},
    {"workMegapix", nullptr, &Params::workMegapix, 0, 1000, false},
    {"referenceImage", &Params::referenceImage, nullptr, -2, 100000, true},
    {"canvasPeriod", nullptr, &Params::canvasPeriod, 0, LONGEST, true},
    {"photometricWeight", nullptr, &Params::photometricWeight, 0, HEAVIEST, true},
    {"geometricWeight", nullptr, &Params::geometricWeight, 0, HEAVIEST, true},
    {"similarityWeight", nullptr, &Params::similarityWeight, 0, HEAVIEST, false},
    {"stretchLimit", nullptr, &Params::stretchLimit, 0, LARGEST, true},
    {"outsideWeight", nullptr, &Params::outsideWeight, 0, HEAVIEST, true},
    {"straightnessWeight", nullptr, &Params::straightnessWeight, 0, HEAVIEST, true},
    {"distortionPrice", nullptr, &Params::distortionPrice, 0, LARGEST, true},
    {"colorSmoothnessWeight", nullptr, &Params::colorSmoothnessWeight, 0, HEAVIEST, false},
    {"colorRestWeight", nullptr, &Params::colorRestWeight, 0, HEAVIEST, false},
    {"sampleStep", &Params::sampleStep, nullptr, 1, 64, true},
    {"lineStep", nullptr, &Params::lineStep, 0.1, LARGEST, true},
    {"pyramidLevels", &Params::pyramidLevels, nullptr, 1, 8, true},
    {"maxIterations", &Params::maxIterations, nullptr, 1, 1000, true},
    {"stopMotion", nullptr, &Params::stopMotion, 0, LARGEST, false},
    {"stopGain", nullptr, &Params::stopGain, 0, 1, true},
    {"contrastFloor", nullptr, &Params::contrastFloor, 0, 1, true},
    {"robustScale", nullptr, &Params::robustScale, 0, LARGEST, true},
    {"gainSupport", nullptr, &Params::gainSupport, 0, HEAVIEST, true},
    {"matchScale", nullptr, &Params::matchScale, 0, LARGEST, true},
    {"anchorWeight", nullptr, &Params::anchorWeight, 0, HEAVIEST, true},
    {"revertRatio", nullptr, &Params::revertRatio, 1, LARGEST, true},
    {"restWeight", nullptr, &Params::restWeight, 0, HEAVIEST, true},
    {"exposureWeight", nullptr, &Params::exposureWeight, 0, HEAVIEST, true},
    {"balanceWeight", nullptr, &Params::balanceWeight, 0, HEAVIEST, true},
    {"minQuadArea", nullptr, &Params::minQuadArea, 0, 0.9, false},
    {"cornerTracking", &Params::cornerTracking, nullptr, 0, 1, true},
    {"contrastThreshold", nullptr, &Params::contrastThreshold, 0, 1, false},
    {"matchRatio", nullptr, &Params::matchRatio, 0, 1, false},
    {"guidedMatching", &Params::guidedMatching, nullptr, 0, 1, true},
    {"featureMegapix", nullptr, &Params::featureMegapix, 0, 1000, false},
};

const Field& find(const std::string& name)
{
    std::string known;
    for (const Field& field : FIELDS)
    {
        if (name == field.name)
            return field;
        known += known.empty() ? field.name : std::string(", ") + field.name;
    }
    CV_Error(Error::StsBadArg, "gcpw::Params has no member '" + name + "'; it has " + known);
}

} // namespace

// The one place of the defaults; the comment beside each member repeats its own (test/defaults_are_as_documented.py).
Params::Params()
{
    method = Method::GCPW;
    meshCols = 32;
    meshRows = 32;
    workMegapix = 0.6;
    referenceImage = -1;
    canvasPeriod = 0;
    photometricWeight = 100;
    geometricWeight = 1;
    similarityWeight = 0.12;
    stretchLimit = 0.5;
    outsideWeight = 0.3;
    straightnessWeight = 8;
    distortionPrice = 2;
    colorSmoothnessWeight = 100;
    colorRestWeight = 1;
    sampleStep = 2;
    lineStep = 5;
    pyramidLevels = 4;
    maxIterations = 10;
    stopMotion = 0.05;
    stopGain = 0.01;
    contrastFloor = 0.03;
    robustScale = 2;
    gainSupport = 3;
    matchScale = 2;
    anchorWeight = 0.5;
    revertRatio = 1.05;
    restWeight = 0.01;
    exposureWeight = 8;
    balanceWeight = 0.4;
    minQuadArea = 0.1;
    cornerTracking = 1;
    contrastThreshold = 0.005;
    matchRatio = 0.85;
    guidedMatching = 1;
    featureMegapix = 2;
}

Params Params::alignmentOnly()
{
    Params p;
    p.similarityWeight = 0.2;
    p.stretchLimit = 0;
    p.straightnessWeight = 0;
    p.distortionPrice = 0;
    p.outsideWeight = 0;
    return p;
}

Params Params::paper()
{
    Params p = alignmentOnly(); // the paper knows no other prior of shape than similarity
    p.similarityWeight = 0.5;
    p.colorSmoothnessWeight = 1;
    p.sampleStep = 3;
    p.pyramidLevels = 3;
    p.maxIterations = 1000;
    p.stopGain = 0;
    p.contrastFloor = 0;
    p.robustScale = 0;
    p.matchScale = 0;
    p.gainSupport = 0;
    p.anchorWeight = 0;
    p.restWeight = 0;
    p.exposureWeight = 0;
    p.balanceWeight = 0;
    p.cornerTracking = 0;
    p.guidedMatching = 0;
    return p;
}

void Params::check() const
{
    const int number = static_cast<int>(method);
    if (number < static_cast<int>(Method::GLOBAL) || number > static_cast<int>(Method::GCPW))
        CV_Error(Error::StsOutOfRange, format("gcpw::Params::method is %d; it must be one of gcpw::Method, 0 to %d", number,
                                              static_cast<int>(Method::GCPW)));
    for (const Field& field : FIELDS)
    {
        const double value = get(field.name);
        const bool inside = (field.low_included ? value >= field.low : value > field.low) && value <= field.high;
        if (inside)
            continue;
        std::ostringstream message;
        message << "gcpw::Params::" << field.name << " is " << value << "; it must be "
                << (field.low_included ? "at least " : "greater than ") << field.low << " and at most " << field.high;
        CV_Error(Error::StsOutOfRange, message.str());
    }
}

void Params::set(const std::string& name, double value)
{
    const Field& field = find(name);
    if (!field.integer)
    {
        this->*field.real = value;
        return;
    }
    if (!(std::abs(value) < 1e9) || value != std::floor(value))
        CV_Error(Error::StsOutOfRange, "gcpw::Params::" + name + " takes a whole number");
    this->*field.integer = static_cast<int>(value);
}

double Params::get(const std::string& name) const
{
    const Field& field = find(name);
    return field.integer ? this->*field.integer : this->*field.real;
}

std::vector<std::string> Params::names()
{
    std::vector<std::string> all;
    for (const Field& field : FIELDS)
        all.emplace_back(field.name);
    return all;
}

} // namespace gcpw
} // namespace cv

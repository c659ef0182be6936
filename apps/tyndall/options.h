// What can be asked of the program, after the command line was understood.
#pragma once

#include <study/reference.h>
#include <tyndall/plan.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "outcome.h"

namespace tyndall::app {

struct Size {
    std::uint32_t width = 640;
    std::uint32_t height = 360;
};

/// Longest side of a picture: what Vulkan devices of today offer at least for render targets.
constexpr std::uint32_t longestSide = 16384;

enum class Layer {
    All,     ///< surfaces and shafts
    Shafts,  ///< the radiance of the shafts alone, hidden behind surfaces as ever
};

struct ViewOptions {
    std::string scene;                  ///< path of the glTF file
    std::optional<std::string> camera;  ///< by name; absent: the file's first
    Size size;
    double time = 0.0;  ///< seconds
    Layer layer = Layer::All;
};

/// Slices a light at most, where it is drawn with as many as needed.
constexpr int defaultMostSlices = 256;

struct ShaftOptions {
    std::optional<TermSet> terms;  ///< of every light; absent: what the view calls for
    Accumulation accumulation = Accumulation::Rgba16f;
    std::optional<int> planes;      ///< so many equal slabs a light; absent: as many as needed
    std::optional<int> mostSlices;  ///< but not more than that; absent: defaultMostSlices
    Geometry geometry = Geometry::ExactPolygons;
    Look look = Look::Physical;
    std::optional<double> range;  ///< absent: automaticRange()
    std::uint32_t shadowSize = 1024;
    bool everything = false;         ///< leaves nothing out, to compare with
    bool displayed = true;           ///< false: radiance is kept as it is, however faint
    std::optional<double> exposure;  ///< stops, of what is displayed; absent: from the picture
};

/// What --pipeline-cache takes in place of a file.
constexpr std::string_view noPipelineCache = "none";

struct RenderOptions {
    ViewOptions view;
    ShaftOptions shafts;
    std::string output;
    std::optional<std::string> stats;
    std::optional<std::string> pipelineCache;  ///< a file, or noPipelineCache; absent: the user's cache folder
    bool validate = false;
};

struct ExplainOptions {
    ViewOptions view;
    ShaftOptions shafts;
    bool json = false;
};

struct ReferenceOptions {
    ViewOptions view;  ///< its layer is not looked at: a reference is of the shafts alone
    std::string output;
    study::Mode mode = study::Mode::Ideal;
    std::optional<TermSet> terms;  ///< absent: each light's own
    double accuracy = 1e-8;
    unsigned threads = 0;
    std::uint32_t shadowSize = 1024;  ///< hardware mode
    std::optional<std::string> stats;
};

/// What a picture may be off by; absent: anything.
struct Limits {
    std::optional<double> relativeL2, relativeMeanSquare, absolute, energy, deadZone;
    std::optional<int> run;
};

struct CompareOptions {
    std::string image, reference;
    bool json = false;
    std::optional<std::string> difference;
    std::optional<double> differenceScale;  ///< absent: the largest difference
    double bandingThreshold = 1e-3;
    Limits most;
};

/// "640x360". Errors: anything else, a side of 0 or over longestSide.
Outcome<Size> parseSize(const std::string& text);

/// The terms of a technique of slices.fx. Errors: another name; the message lists all.
Outcome<TermSet> parseTechnique(const std::string& name);

}  // namespace tyndall::app

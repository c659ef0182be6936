// What a frame is drawn of, and how.
#pragma once

#include <tyndall/plan.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tyndall::app {

struct Size {
    std::uint32_t width = 640;
    std::uint32_t height = 360;
};

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

}  // namespace tyndall::app

// Names of settings on the command line and in the statistics.
#pragma once

#include <study/reference.h>
#include <tyndall/plan.h>

#include <array>
#include <string_view>
#include <utility>

#include "options.h"

namespace tyndall::app {

template <class T, std::size_t N>
using Words = std::array<std::pair<std::string_view, T>, N>;

constexpr Words<Accumulation, 4> accumulationWords{{{"rgba8", Accumulation::Rgba8},
                                                    {"rgba8-routed", Accumulation::Rgba8Routed},
                                                    {"rgba16f", Accumulation::Rgba16f},
                                                    {"rgba32f", Accumulation::Rgba32f}}};
constexpr Words<Method, 2> methodWords{
    {{nameOf(Method::Slices), Method::Slices}, {nameOf(Method::Raycast), Method::Raycast}}};
constexpr Words<Geometry, 2> geometryWords{
    {{"polygons", Geometry::ExactPolygons}, {"quads", Geometry::StretchedQuads}}};
constexpr Words<Look, 2> lookWords{{{"physical", Look::Physical}, {"article", Look::Article}}};
constexpr Words<study::Mode, 2> modeWords{{{"ideal", study::Mode::Ideal}, {"hardware", study::Mode::Hardware}}};
constexpr Words<Layer, 2> layerWords{{{"all", Layer::All}, {"shafts", Layer::Shafts}}};

template <class T, std::size_t N>
std::string_view wordFor(const Words<T, N>& words, T value) {
    for (const auto& [word, meaning] : words)
        if (meaning == value) return word;
    return {};
}

}  // namespace tyndall::app

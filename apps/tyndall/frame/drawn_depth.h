// A drawn depth image, as a plan takes it.
#pragma once

#include <tyndall/surroundings.h>
#include <tyndall/view.h>

#include <span>
#include <vector>

#include "options.h"

namespace tyndall::app {

struct DrawnDepth {
    double farthest = 0.0;  ///< metres of view depth; View{}.sceneDepth where a pixel shows no surface
    std::uint32_t columns = 0, rows = 0;
    std::vector<float> tiles;  ///< as DepthTiles
};

/// From reversed depths as drawn with view.clipFromView, 0 where no surface is, rows from the top.
DrawnDepth summarize(std::span<const float> depths, Size size, const View& view);

}  // namespace tyndall::app

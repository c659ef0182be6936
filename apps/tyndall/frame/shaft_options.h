// How light shafts are drawn.
#pragma once

#include <tyndall/plan.h>

#include <optional>

namespace tyndall::app {

/// Slices a light at most, where it is drawn with as many as needed.
constexpr int defaultMaxSlices = 256;

struct ShaftOptions {
    /// As plan() takes it. Each frame sets its time, pictureHeight, displayStep, and range where `range` is absent.
    PlanOptions plan = {.slices = defaultMaxSlices, .spacing = Spacing::Adaptive};
    std::optional<double> range;     ///< radiance that 8-bit targets call 1; absent: automaticRange()
    bool displayed = true;           ///< false: radiance is kept as it is, however faint
    std::optional<double> exposure;  ///< stops, of what is displayed; absent: from the picture
};

}  // namespace tyndall::app

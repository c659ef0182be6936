// Options for drawing light shafts.
#pragma once

#include <tyndall/plan.h>

#include <optional>

namespace tyndall::app {

/// Maximum number of slices a light, if it is drawn with as many as needed.
constexpr int defaultMaxSlices = 256;

inline PlanOptions adaptivePlan() {
    PlanOptions options;
    options.slices = defaultMaxSlices;
    options.spacing = Spacing::Adaptive;
    return options;
}

struct ShaftOptions {
    /// For plan(). Each frame sets its time, pictureHeight, displayStep, and also range if `range` is absent.
    PlanOptions plan = adaptivePlan();
    std::optional<double> range;     ///< radiance of the value 1 in 8-bit targets; absent: automaticRange()
    bool displayed = true;           ///< false: the output is radiance, and faint light counts too
    std::optional<double> exposure;  ///< stops, if displayed; absent: from the picture
};

}  // namespace tyndall::app

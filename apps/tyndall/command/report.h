// A plan and a frame as JSON and as text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "../frame/frame_statistics.h"
#include "../frame/plan_scene.h"

namespace tyndall::app {

/// Planned lights, lights left out, settings of the view: the common part of both reports.
nlohmann::ordered_json planReport(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts);

/// For `render --stats`.
nlohmann::ordered_json frameReport(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts,
                                   const FrameStatistics& statistics, std::string_view device);

/// For `explain`: one paragraph a light.
std::string planText(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts);

}  // namespace tyndall::app

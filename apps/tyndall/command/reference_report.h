// What computing a reference took, and how accurate it became, as JSON and as text.
#pragma once

#include <study/reference.h>

#include <nlohmann/json.hpp>
#include <string>

#include "../frame/view_scene.h"
#include "options.h"

namespace tyndall::app {

struct ReferenceRun {
    double preparing = 0.0, integrating = 0.0;  ///< seconds
    std::size_t triangles = 0;                  ///< that rays meet; 0 in the hardware mode, which has maps instead
    std::string device;                         ///< that drew the maps; empty in the ideal mode
};

/// For `reference --stats`. The technique is null where each light kept its own terms.
nlohmann::ordered_json referenceReport(const ReferenceOptions& options, const ViewedScene& viewed,
                                       const study::ReferenceImage& image, const ReferenceRun& run);

/// Half a line.
std::string referenceText(const study::ReferenceImage& image, const ReferenceRun& run);

/// A warning for an image whose bound is above the accuracy asked for, with the worst pixel.
std::string shortfall(const ReferenceOptions& options, const study::ReferenceImage& image);

}  // namespace tyndall::app

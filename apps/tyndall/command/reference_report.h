// The cost and accuracy of a reference, as JSON and as text.
#pragma once

#include <study/reference.h>

#include <nlohmann/json.hpp>
#include <string>

#include "../frame/view_scene.h"
#include "options.h"

namespace tyndall::app {

struct ReferenceRun {
    double preparing = 0.0, integrating = 0.0;  ///< seconds
    std::size_t triangles = 0;                  ///< for ray tests; 0 in the hardware mode, which has maps instead
    std::string device;                         ///< that drew the maps; empty in the ideal mode
};

/// For `reference --stats`. The technique is null if each light has its own terms.
nlohmann::ordered_json referenceReport(const ReferenceOptions& options, const ViewedScene& viewed,
                                       const study::ReferenceImage& image, const ReferenceRun& run);

/// A part of a line.
std::string referenceText(const study::ReferenceImage& image, const ReferenceRun& run);

/// A warning for an image whose bound is above the requested accuracy, with the worst pixel.
std::string shortfall(const ReferenceOptions& options, const study::ReferenceImage& image);

}  // namespace tyndall::app

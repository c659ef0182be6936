// The figures of a comparison as JSON and as text, and the limits that they fail.
#pragma once

#include <kit/image/read_picture.h>
#include <study/metrics.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "options.h"

namespace tyndall::app {

struct Comparison {
    ReadPicture image, reference;
    study::Metrics metrics;
};

/// Infinite figures are null, because JSON has no infinity. All figures are null if nothing could be compared.
nlohmann::ordered_json compareReport(const Comparison& comparison, const CompareOptions& options);

std::string compareText(const Comparison& comparison, const CompareOptions& options);

/// One sentence that names each figure out of bounds with its pixel. Values that are not finite always fail.
std::optional<std::string> verdict(const Comparison& comparison, const CompareOptions& options);

}  // namespace tyndall::app

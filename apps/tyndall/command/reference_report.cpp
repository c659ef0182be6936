#include "reference_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "peak_memory.h"
#include "words.h"

namespace tyndall::app {
namespace {

struct Pixel {
    int x, y;
};

Pixel leastAccurate(const study::ReferenceImage& image) {
    const auto at = static_cast<int>(std::ranges::max_element(image.bound) - image.bound.begin());
    return {at % image.width, at / image.width};
}

}  // namespace

nlohmann::ordered_json referenceReport(const ReferenceOptions& options, const ViewedScene& viewed,
                                       const study::ReferenceImage& image, const ReferenceRun& run) {
    nlohmann::ordered_json report;
    report["scene"] = options.view.scene;
    report["camera"] = viewed.camera->name;
    report["size"] = {image.width, image.height};
    report["time"] = options.view.time;
    report["technique"] =
        options.terms ? nlohmann::ordered_json(techniqueName(*options.terms)) : nlohmann::ordered_json();
    report["mode"] = wordFor(modeWords, options.mode);
    if (options.mode == study::Mode::Hardware) {
        report["device"] = run.device;
        report["shadowMapSize"] = options.shadowSize;
    } else {
        report["triangles"] = run.triangles;
    }
    nlohmann::ordered_json& lights = report["lights"] = nlohmann::ordered_json::array();
    for (const Light& light : viewed.lights) {
        nlohmann::ordered_json& entry = lights.emplace_back();
        entry["name"] = light.name;
        for (const Term term : allTerms) entry[nameOf(term)] = termsOf(light).contains(term);
    }
    const Pixel worst = leastAccurate(image);
    report["accuracy"] = {{"asked", options.accuracy},
                          {"reached", image.largestBound},
                          {"leastAccurate", {{"x", worst.x}, {"y", worst.y}}}};
    report["evaluations"] = image.evaluations;
    report["seconds"] = {{"preparing", run.preparing}, {"integrating", run.integrating}};
    report["peakResidentBytes"] = peakResidentBytes();
    return report;
}

std::string referenceText(const study::ReferenceImage& image, const ReferenceRun& run) {
    return fmt::format("{:.1f} s, {} evaluations, relative error at most {:.1e} before the file's rounding of 6e-8",
                       run.integrating, image.evaluations, image.largestBound);
}

std::string shortfall(const ReferenceOptions& options, const study::ReferenceImage& image) {
    const Pixel worst = leastAccurate(image);
    const auto missed = std::ranges::count_if(image.bound, [&](double bound) { return bound > options.accuracy; });
    return fmt::format(
        "warning: --accuracy {:g} was not reached at {} of {} pixels; the worst is ({}, {}), with a bound of {:.1e}",
        options.accuracy, missed, image.bound.size(), worst.x, worst.y, image.largestBound);
}

}  // namespace tyndall::app

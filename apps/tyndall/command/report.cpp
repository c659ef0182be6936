#include "report.h"

#include <tyndall/explain.h>

#include <cmath>
#include <numbers>

#include "peak_memory.h"
#include "words.h"

namespace tyndall::app {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

double milliseconds(double value) {
    return std::round(value * 1000.0) / 1000.0;
}

std::string_view yesNo(bool value, std::string_view yes, std::string_view no) {
    return value ? yes : no;
}

/// What the light calls for, in words.
std::string terms(const PlannedLight& light, const SceneLight& scene, const Light& asked) {
    const std::string_view shadows = light.shadow   ? (scene.movingShadow ? "throws moving shadows" : "throws shadows")
                                     : asked.shadow ? "shadows left out"
                                     : scene.light.shadow ? "no shadows, for nothing stands in its volume"
                                                          : "no shadows";
    return fmt::format("{}, {}, {}", yesNo(light.cookie, "projects a cookie", "no cookie"), shadows,
                       yesNo(light.noise, "drifting dust", "even air"));
}

}  // namespace

nlohmann::ordered_json planReport(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    nlohmann::ordered_json report;
    report["scene"] = view.scene;
    report["camera"] = planned.camera->name;
    report["size"] = {view.size.width, view.size.height};
    report["time"] = view.time;
    report["accumulation"] = wordFor(accumulationWords, shafts.accumulation);
    report["geometry"] = wordFor(geometryWords, shafts.geometry);
    report["look"] = wordFor(lookWords, shafts.look);
    report["planes"] = shafts.planes;
    report["range"] = planned.range;
    report["lights"] = nlohmann::ordered_json::array();
    int slices = 0;
    for (const PlannedLight& light : planned.plan.lights) {
        const Light& source = planned.lights[light.light];
        nlohmann::ordered_json entry;
        entry["name"] = source.name;
        entry["drawn"] = light.drawn;
        entry["reason"] = reason(light, planned.view);
        if (light.drawn) {
            entry["technique"] = light.technique;
            entry["noise"] = light.noise;
            entry["shadow"] = light.shadow;
            entry["cookie"] = light.cookie;
            entry["slices"] = light.slices;
            entry["nearDepth"] = light.nearDepth;
            entry["farDepth"] = light.farDepth;
            slices += light.slices;
        }
        report["lights"].push_back(std::move(entry));
    }
    for (const IgnoredLight& ignored : planned.scene.ignoredLights)
        report["lights"].push_back({{"name", ignored.name}, {"drawn", false}, {"reason", ignored.reason}});
    report["slices"] = slices;
    report["warnings"] = planned.scene.warnings;
    return report;
}

nlohmann::ordered_json frameReport(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts,
                                   const FrameStatistics& statistics, std::string_view device) {
    nlohmann::ordered_json report;
    report["device"] = device;
    report.update(planReport(planned, view, shafts));
    report["draws"] = {{"shafts", statistics.shafts.draws}, {"surfaces", statistics.surfaceDraws}};
    report["shadowMapsDrawn"] = statistics.shafts.shadowMapsDrawn;
    report["slicesDrawn"] = statistics.shafts.slicesDrawn;
    if (statistics.fragmentsKnown) report["fragmentInvocations"] = statistics.fragments;
    report["pipelinesCreated"] = {{"shafts", statistics.shafts.pipelinesCreated},
                                  {"surfaces", statistics.surfacePipelines}};
    report["pipelinesPrepared"] = statistics.shafts.pipelinesPrepared;
    report["memory"] = {{"deviceBytes", statistics.deviceBytes},
                        {"frameDataBytes", statistics.frameDataBytes},
                        {"bytesUploaded", statistics.shafts.bytesUploaded},
                        {"peakResidentBytes", peakResidentBytes()}};
    report["milliseconds"] = {{"pipelines", milliseconds(statistics.pipelines)},
                              {"shadowMaps", milliseconds(statistics.shadowMaps)},
                              {"surfaces", milliseconds(statistics.surfaces)},
                              {"accumulate", milliseconds(statistics.accumulate)},
                              {"composite", milliseconds(statistics.composite)}};
    return report;
}

std::string planText(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    std::string text =
        fmt::format("{}: camera \"{}\", {}x{}, at {:g} s; {} planes a light as {}, added up in {}\n", view.scene,
                    planned.camera->name, view.size.width, view.size.height, view.time, shafts.planes,
                    wordFor(geometryWords, shafts.geometry), wordFor(accumulationWords, shafts.accumulation));
    for (const PlannedLight& light : planned.plan.lights) {
        const Light& source = planned.lights[light.light];
        text +=
            fmt::format("\nlight \"{}\": {}\n  {:g} cd, {:g} x {:g} degrees, from {:g} to {:g} m, density {:g} /m\n",
                        source.name, light.drawn ? "drawn" : "not drawn", source.intensity, source.fov.x / degree,
                        source.fov.y / degree, source.nearPlane, source.farPlane, source.density);
        text += fmt::format("  {}\n", reason(light, planned.view));
        if (!light.drawn) continue;
        text += fmt::format("  technique {}: {}\n", light.technique,
                            terms(light, planned.scene.lights[light.light], source));
        text += fmt::format("  {} slices of {:.4g} m, {:.4g} to {:.4g} m before the eye\n", light.slices,
                            (light.farDepth - light.nearDepth) / light.slices, light.nearDepth, light.farDepth);
    }
    for (const IgnoredLight& ignored : planned.scene.ignoredLights)
        text += fmt::format("\n{}: not drawn\n  {}\n", ignored.name, ignored.reason);
    for (const std::string& warning : planned.scene.warnings) text += fmt::format("\nwarning: {}\n", warning);
    return text;
}

}  // namespace tyndall::app

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

/// What a light costs: expected fragments before the depth test, and bytes on the device.
struct Cost {
    double fragments = 0.0;
    std::uint64_t geometryBytes = 0;
    std::uint64_t shadowMapBytes = 0;
};

Cost costOf(const PlannedScene& planned, const Plan& plan, const ViewOptions& view, const ShaftOptions& shafts,
            std::size_t light) {
    Cost cost;
    const PlannedLight& entry = plan.lights[light];
    if (!entry.drawn) return cost;
    for (const PlannedPart& part : plan.parts)
        if (part.light == light)
            cost.fragments += expectedFragments(plan, part, planned.view, view.size.width, view.size.height);
    // A fan of n corners has n - 2 triangles: vertices are a third of the indices, and two for each slice.
    const std::uint64_t vertices = entry.indexCount / 3 + 2 * static_cast<std::uint64_t>(entry.slices);
    cost.geometryBytes =
        vertices * sizeof(SliceVertex) + entry.indexCount * sizeof(std::uint32_t) + sizeof(SliceConstants);
    if (entry.shadow) cost.shadowMapBytes = std::uint64_t{shafts.shadowSize} * shafts.shadowSize * sizeof(float);
    return cost;
}

std::string count(double number) {
    if (number >= 1e6) return fmt::format("{:.3g} million", number / 1e6);
    if (number >= 1e4) return fmt::format("{:.3g} thousand", number / 1e3);
    return fmt::format("{:.0f}", number);
}

std::string bytes(std::uint64_t number) {
    if (number >= 1u << 20) return fmt::format("{:.3g} MiB", static_cast<double>(number) / (1u << 20));
    if (number >= 1u << 10) return fmt::format("{:.3g} KiB", static_cast<double>(number) / (1u << 10));
    return fmt::format("{} bytes", number);
}

std::string slicesText(const ShaftOptions& shafts) {
    if (shafts.planes) return fmt::format("{} equal slices a light", *shafts.planes);
    return shafts.look == Look::Article
               ? std::string("100 equal slices a light")
               : fmt::format("up to {} slices a light", shafts.mostSlices.value_or(defaultMostSlices));
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
    report["mostSlices"] = planned.options.slices;
    report["spacing"] = planned.options.spacing == Spacing::Even ? "even" : "adaptive";
    report["range"] = planned.range;
    report["displayStep"] = planned.displayStep;
    report["depthKnown"] = planned.depth.has_value();
    report["forceAll"] = shafts.everything;
    report["lights"] = nlohmann::ordered_json::array();
    const Outcome<Plan> everything = planEverything(planned, view);
    int slices = 0;
    std::size_t drawn = 0, shadowMaps = 0;
    Cost total, forcedTotal;
    for (std::size_t i = 0; i < planned.plan.lights.size(); ++i) {
        const PlannedLight& light = planned.plan.lights[i];
        const Cost cost = costOf(planned, planned.plan, view, shafts, i);
        const Cost forced = everything ? costOf(planned, *everything, view, shafts, i) : Cost{};
        nlohmann::ordered_json entry;
        entry["name"] = planned.lights[i].name;
        entry["drawn"] = light.drawn;
        entry["reason"] = reason(light, planned.view);
        if (light.drawn) {
            entry["technique"] = light.technique;
            entry["noise"] = light.noise;
            entry["shadow"] = light.shadow;
            entry["cookie"] = light.cookie;
            entry["saved"] = savings(light);
            entry["slices"] = light.slices;
            entry["nearDepth"] = light.nearDepth;
            entry["farDepth"] = light.farDepth;
            entry["axis"] = {light.seenNear, light.seenFar};
            if (std::isfinite(light.brightest)) entry["brightest"] = light.brightest;
            entry["parts"] = nlohmann::ordered_json::array();
            for (const PlannedPart& part : planned.plan.parts)
                if (part.light == i)
                    entry["parts"].push_back(
                        {{"technique", part.technique},
                         {"slices", part.slices},
                         {"triangles", part.indexCount / 3},
                         {"expectedFragments", std::round(expectedFragments(planned.plan, part, planned.view,
                                                                            view.size.width, view.size.height))}});
            slices += light.slices;
            ++drawn;
            shadowMaps += light.shadow;
        }
        entry["expectedFragments"] = std::round(cost.fragments);
        entry["expectedFragmentsForced"] = std::round(forced.fragments);
        entry["bytes"] = {{"geometry", cost.geometryBytes}, {"shadowMap", cost.shadowMapBytes}};
        total.fragments += cost.fragments;
        forcedTotal.fragments += forced.fragments;
        total.geometryBytes += cost.geometryBytes;
        forcedTotal.geometryBytes += forced.geometryBytes;
        total.shadowMapBytes += cost.shadowMapBytes;
        report["lights"].push_back(std::move(entry));
    }
    for (const IgnoredLight& ignored : planned.scene.ignoredLights)
        report["lights"].push_back({{"name", ignored.name}, {"drawn", false}, {"reason", ignored.reason}});
    report["drawn"] = drawn;
    report["slices"] = slices;
    report["shadowMaps"] = shadowMaps;
    report["expectedFragments"] = std::round(total.fragments);
    report["expectedFragmentsForced"] = std::round(forcedTotal.fragments);
    report["bytes"] = {{"geometry", total.geometryBytes}, {"shadowMaps", total.shadowMapBytes}};
    report["bytesForced"] = {
        {"geometry", forcedTotal.geometryBytes},
        {"shadowMaps", planned.lights.size() * std::uint64_t{shafts.shadowSize} * shafts.shadowSize * sizeof(float)}};
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
    report["images"] = {{"uploaded", statistics.imagesUploaded},
                        {"bytes", statistics.imageBytes},
                        {"ofTheScene", planned.scene.images.size()}};
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
        fmt::format("{}: camera \"{}\", {}x{}, at {:g} s; {} as {}, added up in {}\n", view.scene, planned.camera->name,
                    view.size.width, view.size.height, view.time, slicesText(shafts),
                    wordFor(geometryWords, shafts.geometry), wordFor(accumulationWords, shafts.accumulation));
    if (!planned.depth) text += "planned without the scene's depth: nothing counts as hidden by a surface\n";
    const Outcome<Plan> everything = planEverything(planned, view);
    double fragments = 0.0, forced = 0.0;
    std::size_t drawn = 0, maps = 0;
    for (std::size_t i = 0; i < planned.plan.lights.size(); ++i) {
        const PlannedLight& light = planned.plan.lights[i];
        const Light& source = planned.lights[i];
        const Cost cost = costOf(planned, planned.plan, view, shafts, i);
        const Cost whole = everything ? costOf(planned, *everything, view, shafts, i) : Cost{};
        fragments += cost.fragments;
        forced += whole.fragments;
        text +=
            fmt::format("\nlight \"{}\": {}\n  {:g} cd, {:g} x {:g} degrees, from {:g} to {:g} m, density {:g} /m\n",
                        source.name, light.drawn ? "drawn" : "not drawn", source.intensity, source.fov.x / degree,
                        source.fov.y / degree, source.nearPlane, source.farPlane, source.density);
        text += fmt::format("  {}\n", reason(light, planned.view));
        if (!light.drawn) {
            if (whole.fragments > 0.0) text += fmt::format("  saved: {} fragments\n", count(whole.fragments));
            continue;
        }
        ++drawn;
        maps += light.shadow;
        for (const std::string& saving : savings(light)) text += fmt::format("  {}\n", saving);
        for (const PlannedPart& part : planned.plan.parts)
            if (part.light == i)
                text += fmt::format(
                    "  {}: {} slices, about {} fragments\n", part.technique, part.slices,
                    count(expectedFragments(planned.plan, part, planned.view, view.size.width, view.size.height)));
        text += fmt::format("  its volume spans {:.4g} to {:.4g} m before the eye\n", light.nearDepth, light.farDepth);
        text += fmt::format(
            "  {} of vertices, indices and constants{}; forced: {} fragments\n", bytes(cost.geometryBytes),
            light.shadow ? fmt::format(", {} of shadow map", bytes(cost.shadowMapBytes)) : "", count(whole.fragments));
    }
    for (const IgnoredLight& ignored : planned.scene.ignoredLights)
        text += fmt::format("\n{}: not drawn\n  {}\n", ignored.name, ignored.reason);
    text += fmt::format(
        "\n{} of {} lights drawn with about {} fragments, {} with a shadow map; forced: all with the full technique, "
        "{} "
        "fragments\n",
        drawn, planned.lights.size(), count(fragments), maps, count(forced));
    for (const std::string& warning : planned.scene.warnings) text += fmt::format("\nwarning: {}\n", warning);
    return text;
}

}  // namespace tyndall::app

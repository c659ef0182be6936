#include "report.h"

#include <tyndall/explain.h>

#include <cmath>
#include <numbers>

#include "light_costs.h"
#include "peak_memory.h"
#include "words.h"

namespace tyndall::app {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

double milliseconds(double value) {
    return std::round(value * 1000.0) / 1000.0;
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

/// "up to 256 slices a light as polygons".
std::string methodText(const ShaftOptions& shafts) {
    if (shafts.plan.method == Method::Raycast) return "a ray for each pixel";
    const bool equal = shafts.plan.spacing == Spacing::Even || shafts.plan.look == Look::Article;
    return fmt::format(
        "{} slices a light as {}",
        equal ? fmt::format("{} equal", shafts.plan.slices) : fmt::format("up to {}", shafts.plan.slices),
        wordFor(geometryWords, shafts.plan.geometry));
}

std::string partText(const PlannedPart& part, double fragments) {
    if (part.method == Method::Raycast)
        return fmt::format("  {} of raycast.fx: about {} rays\n", techniqueName(part.terms), count(fragments));
    return fmt::format("  {}: {} slices, about {} fragments\n", techniqueName(part.terms), part.slices,
                       count(fragments));
}

std::string slabsText(const PlannedLight& light) {
    if (light.method == Method::Raycast) return {};
    return fmt::format(", drawn in {} slabs{}", light.slices,
                       light.divided ? ", whose slices both techniques may share" : "");
}

struct Costs {
    std::vector<LightCost> planned, forced;  ///< by light; forced is empty if it would need too many slices
};

Costs costsOf(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    Costs costs{lightCosts(planned.plan, planned.view, view.size, shafts.plan.shadowMapSize), {}};
    if (const Result<Plan> everything = planEverything(planned, view))
        costs.forced = lightCosts(*everything, planned.view, view.size, shafts.plan.shadowMapSize);
    return costs;
}

/// Shadow maps that only surfaces need.
std::size_t mapsForSurfacesAlone(const PlannedScene& planned, const ViewOptions& view) {
    if (view.layer != Layer::All) return 0;
    std::size_t maps = 0;
    for (std::size_t i = 0; i < planned.surfaceLights.size(); ++i) {
        const PlannedLight& light = planned.plan.lights[i];
        maps += planned.surfaceLights[i].shadow && !(light.drawn && light.terms.contains(Term::Shadow));
    }
    return maps;
}

std::string cost(const LightCost& cost) {
    return fmt::format("{} fragments, {} of geometry{}", count(cost.fragments), bytes(cost.geometryBytes),
                       cost.shadowMapBytes > 0 ? fmt::format(", {} of shadow map", bytes(cost.shadowMapBytes)) : "");
}

nlohmann::ordered_json bytesReport(const LightCost& cost, std::string_view shadowMaps) {
    return {{"geometry", cost.geometryBytes}, {shadowMaps, cost.shadowMapBytes}};
}

}  // namespace

nlohmann::ordered_json planReport(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    nlohmann::ordered_json report;
    report["scene"] = view.scene;
    report["camera"] = planned.camera->name;
    report["size"] = {view.size.width, view.size.height};
    report["time"] = view.time;
    report["method"] = nameOf(shafts.plan.method);
    report["accumulation"] = wordFor(accumulationWords, shafts.plan.accumulation);
    report["geometry"] = wordFor(geometryWords, shafts.plan.geometry);
    report["look"] = wordFor(lookWords, shafts.plan.look);
    report["maxSlices"] = planned.options.slices;
    report["spacing"] = planned.options.spacing == Spacing::Even ? "even" : "adaptive";
    report["range"] = planned.range;
    report["displayStep"] = planned.displayStep;
    report["depthKnown"] = planned.depth.has_value();
    report["forceAll"] = shafts.plan.everything;
    report["lights"] = nlohmann::ordered_json::array();
    const Costs costs = costsOf(planned, view, shafts);
    int slices = 0;
    std::size_t drawn = 0, shadowMaps = 0;
    for (std::size_t i = 0; i < planned.plan.lights.size(); ++i) {
        const PlannedLight& light = planned.plan.lights[i];
        const Light& source = planned.lights[i];
        nlohmann::ordered_json entry;
        entry["name"] = source.name;
        entry["intensity"] = source.intensity;
        entry["degrees"] = {source.fov.x / degree, source.fov.y / degree};
        entry["near"] = source.nearPlane;
        entry["far"] = source.farPlane;
        entry["density"] = source.density;
        entry["drawn"] = light.drawn;
        entry["reason"] = reason(light, planned.view);
        if (light.drawn) {
            entry["technique"] = techniqueName(light.terms);
            for (const Term term : allTerms) entry[std::string(nameOf(term))] = light.terms.contains(term);
            entry["saved"] = shafts.plan.everything ? std::vector<std::string>{} : savings(light);
            entry["slices"] = light.slices;
            entry["nearDepth"] = light.nearDepth;
            entry["farDepth"] = light.farDepth;
            entry["axis"] = {light.seenNear, light.seenFar};
            if (std::isfinite(light.brightest)) entry["brightest"] = light.brightest;
            entry["parts"] = nlohmann::ordered_json::array();
            slices += light.slices;
            ++drawn;
            shadowMaps += light.terms.contains(Term::Shadow);
        }
        entry["expectedFragments"] = std::round(costs.planned[i].fragments);
        entry["bytes"] = bytesReport(costs.planned[i], "shadowMap");
        if (!costs.forced.empty()) {
            entry["expectedFragmentsForced"] = std::round(costs.forced[i].fragments);
            entry["bytesForced"] = bytesReport(costs.forced[i], "shadowMap");
        }
        report["lights"].push_back(std::move(entry));
    }
    for (const PlannedPart& part : planned.plan.parts) {
        auto& parts = report["lights"][part.light]["parts"];
        parts.push_back({{"technique", techniqueName(part.terms)},
                         {"slices", part.slices},
                         {"triangles", part.indexCount / 3},
                         {"expectedFragments", std::round(costs.planned[part.light].parts[parts.size()])}});
    }
    for (const IgnoredLight& ignored : planned.scene.ignoredLights)
        report["lights"].push_back({{"name", ignored.name}, {"drawn", false}, {"reason", ignored.reason}});
    report["drawn"] = drawn;
    report["slices"] = slices;
    report["shadowMaps"] = shadowMaps;
    report["shadowMapsForSurfacesAlone"] = mapsForSurfacesAlone(planned, view);
    const LightCost total = sum(costs.planned);
    report["expectedFragments"] = std::round(total.fragments);
    report["bytes"] = bytesReport(total, "shadowMaps");
    if (!costs.forced.empty()) {
        const LightCost forced = sum(costs.forced);
        report["expectedFragmentsForced"] = std::round(forced.fragments);
        report["bytesForced"] = bytesReport(forced, "shadowMaps");
    }
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
    std::string text = fmt::format("{}: camera \"{}\", {}x{}, at {:g} s; {}, added up in {}\n", view.scene,
                                   planned.camera->name, view.size.width, view.size.height, view.time,
                                   methodText(shafts), wordFor(accumulationWords, shafts.plan.accumulation));
    if (!planned.depth) text += "planned without the scene's depth: surfaces are assumed to hide nothing\n";
    const Costs costs = costsOf(planned, view, shafts);
    std::vector<std::vector<const PlannedPart*>> parts(planned.plan.lights.size());
    for (const PlannedPart& part : planned.plan.parts) parts[part.light].push_back(&part);
    std::size_t drawn = 0, maps = 0;
    for (std::size_t i = 0; i < planned.plan.lights.size(); ++i) {
        const PlannedLight& light = planned.plan.lights[i];
        const Light& source = planned.lights[i];
        text +=
            fmt::format("\nlight \"{}\": {}\n  {:g} cd, {:g} x {:g} degrees, from {:g} to {:g} m, density {:g} /m\n",
                        source.name, light.drawn ? "drawn" : "not drawn", source.intensity, source.fov.x / degree,
                        source.fov.y / degree, source.nearPlane, source.farPlane, source.density);
        text += fmt::format("  {}\n", reason(light, planned.view));
        if (light.drawn) {
            ++drawn;
            maps += light.terms.contains(Term::Shadow);
            if (!shafts.plan.everything)
                for (const std::string& saving : savings(light)) text += fmt::format("  {}\n", saving);
            for (std::size_t k = 0; k < parts[i].size(); ++k) text += partText(*parts[i][k], costs.planned[i].parts[k]);
            text += fmt::format("  its volume spans {:.4g} to {:.4g} m before the eye{}\n", light.nearDepth,
                                light.farDepth, slabsText(light));
            text += fmt::format("  costs {}\n", cost(costs.planned[i]));
        }
        if (!shafts.plan.everything && !costs.forced.empty() && costs.forced[i].fragments > 0.0)
            text += fmt::format("  forced, it would cost {}\n", cost(costs.forced[i]));
    }
    for (const IgnoredLight& ignored : planned.scene.ignoredLights)
        text += fmt::format("\n{}: not drawn\n  {}\n", ignored.name, ignored.reason);
    text += fmt::format("\n{} of {} lights drawn, {} with a shadow map: about {}\n", drawn, planned.lights.size(), maps,
                        cost(sum(costs.planned)));
    if (const std::size_t more = mapsForSurfacesAlone(planned, view); more > 0)
        text += fmt::format("{} more shadow map{} for surfaces alone\n", more, more == 1 ? "" : "s");
    if (costs.forced.empty())
        text += "forced: more slices than one plan may hold\n";
    else if (!shafts.plan.everything)
        text +=
            fmt::format("forced, with the full technique and nothing left out: about {}\n", cost(sum(costs.forced)));
    for (const std::string& warning : planned.scene.warnings) text += fmt::format("\nwarning: {}\n", warning);
    return text;
}

}  // namespace tyndall::app

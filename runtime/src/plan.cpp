#include <tyndall/plan.h>

#include "light_volume.h"
#include "plan_check.h"
#include "plan_geometry.h"
#include "plan_groups.h"
#include "plan_technique.h"
#include "slice_constants.h"
#include "view_pose.h"

namespace tyndall {
namespace {

// 2^24 slices of at most 20 corners keep every vertex's number within 32 bits; they would fill 7 GB.
constexpr std::size_t mostSlices = std::size_t{1} << 24;

// Why a light adds nothing wherever it stands; empty where it adds something.
std::string darkness(const Light& light, Look look) {
    if (light.colour == glm::dvec3(0.0)) return "Not drawn: its colour is black.";
    if (look == Look::Article) return {};  // has its own intensity, and no density
    if (light.density == 0.0) return "Not drawn: its air has the density 0 and scatters nothing.";
    if (light.intensity == 0.0 && light.ambient == 0.0) return "Not drawn: its intensity and ambient are both 0.";
    return {};
}

std::string hiddenReason(Hidden hidden, const View& view) {
    switch (hidden) {
        case Hidden::No:
            break;
        case Hidden::ClipPlanes:
            return "Not drawn: its clip planes leave nothing of its volume.";
        case Hidden::BehindEye:
            return "Not drawn: its volume lies wholly behind the eye.";
        case Hidden::BeforeNear:
            return "Not drawn: its volume ends before the view's near plane at " + text(view.nearPlane) + " m.";
        case Hidden::BeyondFar:
            return "Not drawn: its volume begins beyond the view's far plane at " + text(view.farPlane) + " m.";
        case Hidden::BehindScene:
            return "Not drawn: its volume begins behind the farthest visible surface at " + text(view.sceneDepth) +
                   " m.";
        case Hidden::BesideView:
            return "Not drawn: its volume misses the view's frustum sideways.";
    }
    return {};
}

PlannedLight chooseTechnique(const Light& light, std::size_t index, const PlanOptions& options) {
    const Terms calledFor = termsOf(light);
    const Terms terms = options.technique ? termsOf(*options.technique).value_or(calledFor) : calledFor;
    PlannedLight planned;
    planned.light = index;
    planned.technique = techniqueName(terms);
    planned.noise = terms.noise;
    planned.shadow = terms.shadow;
    planned.cookie = terms.cookie;
    planned.reason = techniqueReason(calledFor, terms, options.technique.has_value());
    return planned;
}

// Sets everything of `planned` but its group. Leaves it undrawn, with the reason, where nothing shows.
Result<void> planSlices(Plan& plan, PlannedLight& planned, const Light& light, const View& view,
                        const PlanOptions& options) {
    const auto leaveOut = [&](std::string reason) { planned.reason = std::move(reason); };
    if (std::string reason = darkness(light, options.look); !reason.empty()) {
        leaveOut(std::move(reason));
        return {};
    }
    const LightPose pose = lightPose(light.worldFromLight, view.worldFromView);
    const LightVolume volume = lightVolume(light, view, pose);
    if (volume.hidden != Hidden::No) {
        leaveOut(hiddenReason(volume.hidden, view));
        return {};
    }
    planned.constants =
        sliceConstants(light, view, options, pose, volume, {planned.noise, planned.shadow, planned.cookie});
    if (!isFinite(planned.constants))
        return broken(placeOf(light, planned.light) +
                      ": its strength, noise or time is beyond what 32-bit floats hold: colour * density / range, "
                      "intensity, ambient, noise scale, gain and scroll * time must each stay under 3e38; lower them");
    planned.slices = options.slices;
    planned.nearDepth = volume.nearDepth;
    planned.farDepth = volume.farDepth;
    if (plan.geometry == Geometry::ExactPolygons)
        appendPolygons(plan, planned, volume);
    else
        appendQuads(plan, planned);
    planned.drawn = true;
    return {};
}

}  // namespace

Result<Plan> plan(std::span<const Light> lights, const View& view, const PlanOptions& options) {
    if (const Result<void> checked = checkOptions(options); !checked) return tl::unexpected(checked.error());
    if (const Result<void> checked = checkView(view); !checked) return tl::unexpected(checked.error());
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (const Result<void> checked = checkLight(lights[i], i, options); !checked)
            return tl::unexpected(checked.error());
    if (lights.size() > mostSlices / static_cast<std::size_t>(options.slices))
        return broken("plan options: slices is " + std::to_string(options.slices) + " for each of " +
                      std::to_string(lights.size()) + " lights: they must come to at most " +
                      std::to_string(mostSlices) + " together; lower slices, or leave out lights");

    Plan result;
    result.geometry = options.geometry;
    result.accumulation = options.accumulation;
    result.scale = targetScale(options);
    result.lights.reserve(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        result.lights.push_back(chooseTechnique(lights[i], i, options));
        if (const Result<void> planned = planSlices(result, result.lights.back(), lights[i], view, options); !planned)
            return tl::unexpected(planned.error());
    }
    formGroups(result, lights);
    return result;
}

}  // namespace tyndall

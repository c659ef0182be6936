#include <tyndall/plan.h>

#include "check/plan_check.h"
#include "geometry/capacity.h"
#include "plan_geometry.h"
#include "plan_groups.h"
#include "plan_stages.h"
#include "slice_constants.h"

namespace tyndall {
namespace {

// 2^24 slices of at most 28 corners keep every vertex's number within 32 bits; they would fill 9 GB.
constexpr std::size_t maxSlices = std::size_t{1} << 24;

void clear(Plan& plan) {
    plan.vertices.clear();
    plan.indices.clear();
    plan.constants.clear();
    plan.walls.clear();
    plan.lights.clear();
    plan.parts.clear();
    plan.groups.clear();
}

Result<void> checkSlices(std::span<const Candidate> candidates) {
    std::size_t slices = 0;
    for (const Candidate& candidate : candidates) slices += static_cast<std::size_t>(candidate.slabs.count);
    if (slices <= maxSlices) return {};
    return at("plan options", {ErrorCode::InvalidArgument,
                               "plan options: " + std::to_string(candidates.size()) + " lights are to be drawn with " +
                                   std::to_string(slices) + " slices: they must come to at most " +
                                   std::to_string(maxSlices) + " together; lower slices, or leave out lights"});
}

}  // namespace

struct Planner::Impl {
    std::vector<Candidate> candidates;
    std::vector<Omission> omissions;
    std::vector<std::uint32_t> indices;
    ConsiderScratch scratch;

    Result<void> check(std::span<const Light> lights, const View& view, const PlanOptions& options,
                       const Surroundings& surroundings);
    void consider(const PlanContext& context, std::span<const Light> lights, Plan& plan);
    Result<void> draw(std::span<const Light> lights, const View& view, const PlanOptions& options, Plan& plan);
};

Result<void> Planner::Impl::check(std::span<const Light> lights, const View& view, const PlanOptions& options,
                                  const Surroundings& surroundings) {
    if (const Result<void> checked = checkOptions(options); !checked) return at("plan options", checked.error());
    if (const Result<void> checked = checkView(view); !checked) return at("view", checked.error());
    if (const Result<void> checked = checkSurroundings(surroundings, lights.size()); !checked)
        return at("surroundings", checked.error());
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (const Result<void> checked = checkLight(lights[i], i, options); !checked)
            return at(placeOf(lights[i], i), checked.error());
    return {};
}

void Planner::Impl::consider(const PlanContext& context, std::span<const Light> lights, Plan& plan) {
    candidates.clear();
    plan.lights.resize(lights.size());
    const std::span<const LightSurvey> surveys = context.surroundings.surveys;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        PlannedLight& planned = plan.lights[i] = {};
        planned.light = i;
        Candidate& candidate = candidates.emplace_back();
        candidate.light = static_cast<std::uint32_t>(i);
        if (!tyndall::consider(context, lights[i], surveys.empty() ? LightSurvey{} : surveys[i], planned, candidate,
                               scratch))
            candidates.pop_back();
    }
}

Result<void> Planner::Impl::draw(std::span<const Light> lights, const View& view, const PlanOptions& options,
                                 Plan& plan) {
    for (const Candidate& candidate : candidates) {
        PlannedLight& planned = plan.lights[candidate.light];
        const Light& light = lights[candidate.light];
        if (planned.verdict != Verdict::Drawn) continue;
        const SliceConstants constants =
            sliceConstants(light, view, options, candidate.seen.pose, candidate.seen.volume, candidate.slabs,
                           planned.terms, candidate.shadowBias, candidate.needed.standIns);
        if (!isFinite(constants)) {
            const std::string place = placeOf(light, candidate.light);
            return at(
                place,
                {ErrorCode::InvalidArgument,
                 place + ": its strength, noise or time is beyond what 32-bit floats hold: colour * density / range, "
                         "density / albedo, intensity, ambient, noise scale, gain and scroll * time must each stay "
                         "under 3e38; lower them"});
        }
        plan.constants.push_back(constants);
        planned.firstWall = static_cast<std::uint32_t>(plan.walls.size());
        const LightVolume& volume = candidate.seen.volume;
        plan.walls.insert(plan.walls.end(), volume.walls.begin(), volume.walls.end());
        planned.nearDepth = candidate.slabs.nearDepth;
        planned.farDepth = candidate.slabs.farDepth;
        planned.drawn = true;
        if (plan.geometry == Geometry::ExactPolygons)
            appendPolygons(plan, planned, light, candidate, options, indices);
        else
            appendQuads(plan, planned, candidate, options);
    }
    return {};
}

Planner::Planner() : impl_(std::make_unique<Impl>()) {}
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;
Planner::~Planner() = default;

Result<void> Planner::plan(std::span<const Light> lights, const View& view, const PlanOptions& options,
                           const Surroundings& surroundings, Plan& plan) try {
    clear(plan);
    if (const Result<void> checked = impl_->check(lights, view, options, surroundings); !checked) return checked;
    const PlanContext context{view, options, surroundings, viewSides(view, 1.0)};

    plan.geometry = options.geometry;
    plan.accumulation = options.accumulation;
    plan.scale = targetScale(options);
    impl_->consider(context, lights, plan);
    leaveOutTheFaint(options, impl_->candidates, plan.lights, impl_->omissions);
    Result<void> done = checkSlices(impl_->candidates);
    if (done) done = impl_->draw(lights, view, options, plan);
    if (!done) {
        clear(plan);
        return done;
    }
    formGroups(plan, lights);
    return {};
} catch (const CapacityExceeded& exceeded) {
    clear(plan);
    return tl::unexpected(internalError(exceeded));
}

Result<void> Planner::surfaces(std::span<const Light> lights, const View& view, std::uint32_t shadowMapSize,
                               const Surroundings& surroundings, std::vector<SurfaceLight>& needs) try {
    PlanOptions options;
    options.shadowMapSize = shadowMapSize;
    if (const Result<void> checked = impl_->check(lights, view, options, surroundings); !checked) {
        needs.clear();
        return checked;
    }
    needs.resize(lights.size());
    const PlanContext context{view, options, surroundings, viewSides(view, 1.0)};
    for (std::size_t i = 0; i < lights.size(); ++i) surfaceLight(context, lights[i], needs[i], impl_->scratch);
    return {};
} catch (const CapacityExceeded& exceeded) {
    needs.clear();
    return tl::unexpected(internalError(exceeded));
}

Result<Plan> plan(std::span<const Light> lights, const View& view, const PlanOptions& options,
                  const Surroundings& surroundings) {
    Plan result;
    if (const Result<void> done = Planner().plan(lights, view, options, surroundings, result); !done)
        return tl::unexpected(done.error());
    return result;
}

}  // namespace tyndall

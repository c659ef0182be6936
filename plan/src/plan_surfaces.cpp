#include "plan_stages.h"

namespace tyndall {

void surfaceLight(const PlanContext& context, const Light& light, SurfaceLight& needed, ConsiderScratch& scratch) {
    needed.lit = needed.shadow = false;
    needed.walls.clear();
    if (light.colour == glm::dvec3(0.0) || (light.intensity == 0.0 && light.ambient == 0.0)) return;

    PerTerm<TermVerdict> asked;
    if (light.shadow) asked[Term::Shadow] = TermVerdict::Drawn;
    const SeenLight seen = seenLight(context, light, {}, asked, scratch.lit, scratch.walls);
    if (seen.verdict != Verdict::Drawn) return;
    needed.lit = true;
    needed.shadow = light.shadow;
    if (light.shadow && context.surroundings.occluders)
        needed.shadow = shadowNeed(light, seen.pose, seen.air, seen.walls, *context.surroundings.occluders,
                                   context.options.shadowMapSize, scratch.shadows)
                            .needed;
    needed.walls.assign(seen.volume.walls.begin(), seen.volume.walls.end());
}

}  // namespace tyndall

#include "visibility/seen_light.h"

#include <algorithm>

#include "shape/light_shape.h"
#include "visibility/pixel_size.h"

namespace tyndall {
namespace {

// Metres by which a rasterizer may move an edge of a slice, because it rounds corners to 1/256 pixel. Slices end this
// much farther behind a wall; otherwise a pixel whose slice lies just before the wall would lose its light.
double snapping(const View& view, const PlanOptions& options, double maxDepth) {
    constexpr double diagonal = 1.4143 / 512.0;
    return diagonal * pixelSize(view, options.pictureHeight, maxDepth);
}

}  // namespace

SeenLight seenLight(const PlanContext& context, const Light& light, const LightSurvey& survey,
                    const PerTerm<TermVerdict>& asked, ConvexPolyhedron& lit, WallScratch& scratch) {
    const auto& [view, options, surroundings, sides] = context;
    const bool whole = options.everything;
    SeenLight seen;
    seen.pose = lightPose(light.worldFromLight, view.worldFromView);
    if (!whole) seen.verdict = hiddenBySphere(light, view, seen.pose, sides);
    if (seen.verdict != Verdict::Drawn) return seen;

    // Stretched quads have no clip distance left for walls.
    if (surroundings.blockers && light.shadow && asked[Term::Shadow] != TermVerdict::Overruled &&
        options.geometry == Geometry::ExactPolygons)
        seen.walls = wallsOf(light, view, seen.pose, *surroundings.blockers, options.shadowMapSize, scratch);
    InlineVector<glm::dvec4, 8> beam;
    if (light.cookie && survey.cookie && asked[Term::Cookie] != TermVerdict::Overruled)
        beam = beamSides(light, seen.pose, *survey.cookie);
    seen.volume = lightVolume(light, view, seen.pose, seen.walls, beam, lit);
    LightVolume& volume = seen.volume;
    seen.verdict = volume.hidden;
    seen.measured = volume.farDepth > volume.nearDepth;
    if (!seen.drawable(options)) return seen;
    const double moved = snapping(view, options, std::min(volume.farLit, volume.farShown));
    for (glm::dvec4& wall : volume.walls) wall.w += moved;

    if (seen.verdict == Verdict::Drawn) seen.air = seenAir(lit, shapeOf(light), view, seen.pose, surroundings.depth);
    if (!seen.air.any && !whole) seen.verdict = Verdict::BehindTiles;
    return seen;
}

}  // namespace tyndall

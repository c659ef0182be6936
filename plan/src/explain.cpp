#include <tyndall/explain.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "check/plan_check.h"
#include "geometry/slice_polygon.h"

namespace tyndall {
namespace {

// "noise", "noise and shadow", "noise, shadow and cookie"
std::string listed(const std::vector<std::string>& words) {
    std::string sentence;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) sentence += i + 1 == words.size() ? " and " : ", ";
        sentence += words[i];
    }
    return sentence;
}

// Metres with three digits, for reading.
std::string metres(double length) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.3g m", length);
    return digits;
}

std::string drawnReason(const PlannedLight& light) {
    std::vector<std::string> wanted, spared;
    bool forced = false;
    for (const Term term : allTerms) {
        const TermVerdict verdict = light.verdicts[term];
        forced = forced || verdict == TermVerdict::Forced || verdict == TermVerdict::Overruled;
        (isDrawn(verdict) ? wanted : spared).emplace_back(nameOf(term));
    }
    if (forced) return "The options force this technique.";
    if (wanted.empty()) return "The view needs none of " + listed(spared) + ".";
    if (spared.empty()) return "The view needs " + listed(wanted) + ".";
    return "The view needs " + listed(wanted) + ", but not " + listed(spared) + ".";
}

// The area of a triangle's part in the square from -1 to 1.
double triangleAreaWithin(const std::array<glm::dvec2, 3>& corners, std::span<const glm::dvec4> sides) {
    SlicePolygon polygon;
    for (const glm::dvec2& corner : corners) polygon.corners[polygon.count++] = corner;
    if (area(polygon) < 0.0) std::swap(polygon.corners[1], polygon.corners[2]);  // Vulkan's clip space has y down
    for (const glm::dvec4& side : sides) {
        SlicePolygon inside, outside;
        split(polygon, glm::dvec2(side), side.w, inside, outside);
        polygon = inside;
    }
    return std::fabs(area(polygon));
}

}  // namespace

std::string reason(const PlannedLight& light, const View& view) {
    switch (light.verdict) {
        case Verdict::Drawn:
            return drawnReason(light);
        case Verdict::Black:
            return "Not drawn: its colour is black.";
        case Verdict::NoDensity:
            return "Not drawn: its air has the density 0 and scatters nothing.";
        case Verdict::NoStrength:
            return "Not drawn: its intensity and ambient are both 0.";
        case Verdict::ClipPlanes:
            return "Not drawn: its clip planes leave nothing of its volume.";
        case Verdict::BehindEye:
            return "Not drawn: its volume lies wholly behind the eye.";
        case Verdict::BeforeNear:
            return "Not drawn: its volume ends before the view's near plane at " + text(view.nearPlane) + " m.";
        case Verdict::BeyondFar:
            return "Not drawn: its volume begins beyond the view's far plane at " + text(view.farPlane) + " m.";
        case Verdict::BehindScene:
            return "Not drawn: its volume begins behind the farthest visible surface at " + text(view.sceneDepth) +
                   " m.";
        case Verdict::BesideView:
            return "Not drawn: its volume misses the view's frustum sideways.";
        case Verdict::BehindWalls:
            return "Not drawn: the part of its volume in the view lies behind blockers that stop all its light.";
        case Verdict::BehindTiles:
            return "Not drawn: surfaces hide all of its volume.";
        case Verdict::DarkCookie:
            return "Not drawn: its cookie is black in all of its seen volume.";
        case Verdict::NoDust:
            return "Not drawn: its noise is 0 everywhere.";
        case Verdict::Absorbed:
            return "Not drawn: its air absorbs all light before it reaches the eye.";
        case Verdict::TooFaint:
            return "Not drawn: no pixel would get more than a radiance of " + text(light.brightest) +
                   " from it, too little for the display to show.";
    }
    return {};
}

std::vector<std::string> savings(const PlannedLight& light) {
    std::vector<std::string> sentences;
    if (!light.drawn) return sentences;
    if (light.verdicts[Term::Shadow] == TermVerdict::NoOccluder)
        sentences.push_back("No shadow map: nothing stands between the lamp and the air that is seen.");
    for (const Term term : allTerms) {
        const std::string name(nameOf(term));
        if (light.verdicts[term] == TermVerdict::Uniform)
            sentences.push_back("No " + name + ": it is the same in all of the seen air; a factor replaces it.");
        if (light.verdicts[term] == TermVerdict::Invisible)
            sentences.push_back("No " + name + ": it differs by less than the display shows; its mean replaces it.");
        if (light.verdicts[term] == TermVerdict::Overruled)
            sentences.push_back("No " + name + ": the options leave it out.");
    }
    if (light.walls > 0)
        sentences.push_back("Ends at " + std::string(light.walls == 1 ? "a wall" : "walls") + " that stop" +
                            (light.walls == 1 ? "s" : "") + " all its light.");
    const double whole = light.volumeFar - light.volumeNear;
    const double seen = light.seenFar - light.seenNear;
    if (seen > 0.0 && seen < 0.9 * whole)
        sentences.push_back("Seen: " + metres(seen) + " of its " + metres(whole) + " along the axis, from " +
                            metres(light.seenNear) + " to " + metres(light.seenFar) + ".");
    if (light.divided)
        sentences.push_back("Shadow looked up only where occluders can throw one, the first of them " +
                            metres(light.firstOccluder) + " from the lamp.");
    return sentences;
}

double expectedFragments(const Plan& plan, const PlannedPart& part, const View& view, std::uint32_t width,
                         std::uint32_t height) {
    const bool slices = part.method == Method::Slices;
    const SliceConstants constants = slices ? plan.constants[part.constants] : SliceConstants{};
    const glm::dvec3 origin(constants.boundsMin), extent = glm::dvec3(constants.boundsMax) - origin;
    const glm::dvec4 pictureSides[] = {{1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}};
    double covered = 0.0;
    for (std::uint32_t i = part.firstIndex; i < part.firstIndex + part.indexCount; i += 3) {
        // Slices lie across the view's axis: in clip space divided by w they keep their shape.
        std::array<glm::dvec2, 3> corners;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const glm::dvec3 position(plan.vertices[plan.indices[i + k]].position);
            const glm::dvec4 clip = slices ? view.clipFromView * glm::dvec4(origin + extent * position, 1.0)
                                           : glm::dvec4(position, 1.0);  // an outline
            corners[k] = glm::dvec2(clip) / clip.w;
        }
        covered += triangleAreaWithin(corners, pictureSides);
    }
    return 0.25 * covered * width * height;
}

}  // namespace tyndall

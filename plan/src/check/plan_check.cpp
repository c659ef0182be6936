#include "check/plan_check.h"

#include <cfloat>
#include <cmath>
#include <cstdio>

namespace tyndall {

std::string text(double number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", number);
    return digits;
}

std::string text(const glm::dvec3& v) {
    return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")";
}

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

tl::unexpected<Error> broken(const std::string& sentence) {
    return tl::unexpected<Error>(Error{ErrorCode::InvalidArgument, sentence});
}

tl::unexpected<Error> at(std::string place, Error error) {
    error.place = std::move(place);
    return tl::unexpected(std::move(error));
}

Result<void> checkBounds(const CheckedObject& place, std::span<const Bound> bounds) {
    for (const Bound& bound : bounds)
        if (!(bound.value >= bound.min && bound.value <= bound.max))  // NaN is in no range
            return broken(place.text() + ": " + std::string(bound.field) + " is " + text(bound.value) +
                          ": it must be " + std::string(bound.rule) + "; " + std::string(bound.remedy));
    return {};
}

Result<void> checkRigid(const CheckedObject& place, std::string_view field, const glm::dmat4& pose) {
    const auto name = [&] { return place.text() + ": " + std::string(field); };
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(pose[column][row]))
                return broken(name() + " has " + text(pose[column][row]) + " in row " + std::to_string(row) +
                              ", column " + std::to_string(column) +
                              ": it must be finite; check what it was computed from, an up vector parallel to the "
                              "direction for one");
    const glm::dmat3 rotation(pose);
    const glm::dmat3 gram = glm::transpose(rotation) * rotation;
    double off = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            off = std::fmax(off, std::fabs(gram[column][row] - (column == row ? 1.0 : 0.0)));
    if (off > rigidTolerance)
        return broken(name() + " is not rigid, its columns' dot products are off a rotation's by " + text(off) +
                      ": it must be a rotation and a translation to within " + text(rigidTolerance) +
                      "; take scale and shear out of it");
    if (glm::determinant(rotation) < 0.0)
        return broken(name() + " mirrors, its determinant is " + text(glm::determinant(rotation)) +
                      ": it must be a rotation and a translation; take the negative scale out of it");
    const glm::dvec4 lastRow = glm::transpose(pose)[3];
    if (lastRow != glm::dvec4(0.0, 0.0, 0.0, 1.0))
        return broken(
            name() + " has the last row (" + text(lastRow.x) + ", " + text(lastRow.y) + ", " + text(lastRow.z) + ", " +
            text(lastRow.w) +
            "): it must be (0, 0, 0, 1); matrices multiply column vectors, so translation is the last column");
    const glm::dvec3 position(pose[3]);
    for (int axis = 0; axis < 3; ++axis)
        if (std::fabs(position[axis]) > farthest)
            return broken(name() + " has the position " + text(position[axis]) + ": it must lie within " +
                          text(farthest) + " m of the origin; move the origin nearer to the scene");
    return {};
}

Result<void> checkOptions(const PlanOptions& options) {
    const std::string place = "plan options";
    const Bound bounds[] = {
        {"slices", static_cast<double>(options.slices), 1, 65536, "from 1 to 65536", "100 is a good start"},
        {"time", options.time, -DBL_MAX, DBL_MAX, "finite", "give seconds since the noise began to scroll"},
        {"range", options.range, DBL_MIN, DBL_MAX, "positive and finite",
         "give the radiance that white stands for, 1 for one"},
        {"shadowMapSize", static_cast<double>(options.shadowMapSize), 1, 65536, "from 1 to 65536",
         "give the texels a side of the map that is drawn"},
        {"displayStep", options.displayStep, 0.0, DBL_MAX, "0 or more and finite",
         "give the radiance of the display's smallest step, 0 to leave nothing out"},
        {"shadowBias", options.shadowBias, 0.0, farthest, "from 0 to 1e9 m", "a centimetre is a good start"},
    };
    if (const Result<void> checked = checkBounds({place}, bounds); !checked) return checked;
    if (options.method == Method::Slices && options.accumulation == Accumulation::Rgba8Routed &&
        options.slices % 4 != 0)
        return broken(place + ": slices is " + std::to_string(options.slices) +
                      ": it must be a multiple of 4 where slices are routed into four channels; take " +
                      std::to_string(options.slices / 4 * 4 + 4) + ", or another accumulation format");
    return {};
}

Result<void> checkSurroundings(const Surroundings& surroundings, std::size_t lights) {
    const std::string place = "surroundings";
    if (!surroundings.surveys.empty() && surroundings.surveys.size() != lights)
        return broken(place + ": surveys has " + std::to_string(surroundings.surveys.size()) + " entries for " +
                      std::to_string(lights) + " lights: it must have one for each, or none at all");
    for (std::size_t i = 0; i < surroundings.surveys.size(); ++i)
        for (const TextureSurvey* survey : {surroundings.surveys[i].cookie, surroundings.surveys[i].noise})
            if (survey && (survey->columns < 1 || survey->rows < 1 || !(survey->detail > 0.0) ||
                           survey->cells.size() !=
                               static_cast<std::size_t>(survey->columns) * static_cast<std::size_t>(survey->rows)))
                return broken(place + ": a survey of light " + std::to_string(i) +
                              " is not complete; make it with surveyTexture()");
    if (!surroundings.depth) return {};
    const DepthTiles& tiles = *surroundings.depth;
    if (tiles.columns == 0 || tiles.rows == 0 || tiles.farthest.size() != std::size_t{tiles.columns} * tiles.rows)
        return broken(place + ": depth has " + std::to_string(tiles.farthest.size()) + " tiles for " +
                      std::to_string(tiles.columns) + " columns and " + std::to_string(tiles.rows) +
                      " rows: it must have columns * rows of them, one at least");
    for (const float depth : tiles.farthest)
        if (!(depth >= 0.0f))
            return broken(place + ": a tile's depth is " + text(depth) +
                          ": it must be 0 or more; give infinity where no surface shows");
    return {};
}

}  // namespace tyndall

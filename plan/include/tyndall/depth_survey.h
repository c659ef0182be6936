// What a plan learns from a drawn depth buffer: the farthest visible surface of each tile.
#pragma once

#include <tyndall/result.h>
#include <tyndall/view.h>

#include <cstdint>
#include <span>
#include <vector>

namespace tyndall {

/// The scene's depth as drawn for the view that is planned.
struct DepthTiles {
    std::uint32_t columns = 0, rows = 0;  ///< of equal tiles over the picture; row 0 at its top
    /// Metres of view depth, row by row: the largest of all pixels that the tile overlaps. Infinite where a pixel shows
    /// no surface.
    std::span<const float> farthest;
};

/// A depth buffer in at most 16 x 9 tiles. Finer tiles do not pay for a light that fills the picture: each tile costs
/// plan() about a microsecond for such a light.
struct DepthSurvey {
    double farthest = 0.0;  ///< for View::sceneDepth: the largest of the tiles, at most the default of that field
    std::uint32_t columns = 0, rows = 0;
    std::vector<float> tiles;

    /// For Surroundings::depth. Must not outlive the survey.
    DepthTiles asTiles() const { return {columns, rows, tiles}; }
};

/// Surveys `depths` as drawn with view.clipFromView: one for each of width * height pixels, rows from the top, in
/// Vulkan's range of 0 to 1. The projection decides whether depth is reversed (1 near, 0 far) or not (0 near, 1 far). A
/// pixel at the far end of the range, beyond it or without a number shows no surface: its tile is infinitely far. A
/// surface counts as farther than stored, to allow for the rounding of 32-bit floats: by 1e-5 of its distance or by two
/// steps of the stored number, whichever is more. Two steps are more for far surfaces in a buffer that is not reversed.
/// Keeps the memory of `survey`: nothing is allocated for the next buffer of that size.
///
/// Errors: InvalidArgument where the view breaks its bounds, width or height is 0, the number of depths is not
/// width * height, or the projection's depth depends on x or y (an oblique near plane). `survey` is then unchanged.
/// A plan without depth tiles is right in all of these cases: nothing counts as hidden by a surface.
Result<void> surveyDepth(std::span<const float> depths, std::uint32_t width, std::uint32_t height, const View& view,
                         DepthSurvey& survey);

}  // namespace tyndall

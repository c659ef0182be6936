// What plan() may know of a texture without reading it: its range of values, and how fine its detail is.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace tyndall {

/// Bounds of each channel.
struct TextureRange {
    glm::vec3 min{0.0f};
    glm::vec3 max{0.0f};
};

/// A texture's values, cell by cell. One survey serves all the lights that share the texture.
struct TextureSurvey {
    int columns = 0, rows = 0;        ///< of cells; row 0 is the texture's top
    std::vector<TextureRange> cells;  ///< of every texel that bilinear filtering reads within the cell
    TextureRange whole;
    /// Octagon of texture coordinates outside of which a clamped lookup is black, as a cone's cookie is in its corners:
    /// bounds of u, v, u + v and u - v. A minimum above its maximum means that nothing is lit.
    std::array<double, 4> litMin{0.0, 0.0, 0.0, -1.0}, litMax{1.0, 1.0, 2.0, 1.0};
    double detail = 1.0;  ///< share of the texture's side over which it changes by its whole range, from the steepest
                          ///< step between neighbouring texels: a hard edge is a texel wide, a soft cone half the side
};

/// Surveys a texture of linear values, RGBA, row 0 at the top, in at most 32 x 32 cells.
/// `width` and `height` must be at least 1 and `texels` hold width * height values. `wraps`: the texture repeats,
/// as noise does; otherwise its edge is clamped, as a cookie's.
TextureSurvey surveyTexture(int width, int height, std::span<const glm::vec4> texels, bool wraps);

/// The same for a texture of half floats (VK_FORMAT_R16G16B16A16_SFLOAT) that `texels` are stored in: each value is
/// rounded to the nearest half float. A survey of the values before they are rounded does not bound what is drawn.
TextureSurvey surveyHalfFloatTexture(int width, int height, std::span<const glm::vec4> texels, bool wraps);

/// Bounds of the values that bilinear filtering reads from a clamped texture within a rectangle of texture coordinates.
TextureRange rangeWithin(const TextureSurvey& survey, const glm::dvec2& min, const glm::dvec2& max);

}  // namespace tyndall

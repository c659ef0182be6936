#include <tyndall/texture_survey.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace tyndall {
namespace {

constexpr int maxCells = 32;

void widen(TextureRange& range, const TextureRange& other) {
    range.min = glm::min(range.min, other.min);
    range.max = glm::max(range.max, other.max);
}

class Texels {
public:
    Texels(int width, int height, std::span<const glm::vec4> texels, bool wraps)
        : width_(width), height_(height), texels_(texels), wraps_(wraps) {}
    glm::vec3 at(int column, int row) const {
        column = wraps_ ? (column + width_) % width_ : std::clamp(column, 0, width_ - 1);
        row = wraps_ ? (row + height_) % height_ : std::clamp(row, 0, height_ - 1);
        return texels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(column)];
    }

private:
    int width_, height_;
    std::span<const glm::vec4> texels_;
    bool wraps_;
};

// Texels that filtering reads between two texture coordinates, given as cell `i` of `cells` over `side` texels:
// those whose centres are less than a texel away.
std::pair<int, int> texelsRead(int i, int cells, int side) {
    const double first = static_cast<double>(i) * side / cells, last = static_cast<double>(i + 1) * side / cells;
    return {static_cast<int>(std::floor(first - 0.5)), static_cast<int>(std::ceil(last - 0.5))};
}

double step(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 difference = glm::abs(a - b);
    return std::max({difference.r, difference.g, difference.b});
}

// Filtering carries a texel's light to where its own and its neighbours' centres are: a texel to each side.
void findLit(TextureSurvey& survey, int width, int height, const Texels& source) {
    constexpr double nothing = 1e300;
    survey.litMin.fill(nothing);
    survey.litMax.fill(-nothing);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (source.at(x, y) == glm::vec3(0.0f)) continue;
            for (const int right : {-1, 1})
                for (const int down : {-1, 1}) {
                    // Beyond the edge a clamped texel goes on for ever, and no pyramid does.
                    const double u = std::clamp((x + 0.5 + right) / width, 0.0, 1.0);
                    const double v = std::clamp((y + 0.5 + down) / height, 0.0, 1.0);
                    const double along[] = {u, v, u + v, u - v};
                    for (std::size_t i = 0; i < 4; ++i) {
                        survey.litMin[i] = std::min(survey.litMin[i], along[i]);
                        survey.litMax[i] = std::max(survey.litMax[i], along[i]);
                    }
                }
        }
}

}  // namespace

TextureSurvey surveyTexture(int width, int height, std::span<const glm::vec4> texels, bool wraps) {
    const Texels source(width, height, texels, wraps);
    TextureSurvey survey;
    survey.columns = std::min(width, maxCells);
    survey.rows = std::min(height, maxCells);
    survey.whole = {source.at(0, 0), source.at(0, 0)};
    for (int row = 0; row < survey.rows; ++row)
        for (int column = 0; column < survey.columns; ++column) {
            const auto [left, right] = texelsRead(column, survey.columns, width);
            const auto [top, bottom] = texelsRead(row, survey.rows, height);
            TextureRange range{source.at(left, top), source.at(left, top)};
            for (int y = top; y <= bottom; ++y)
                for (int x = left; x <= right; ++x) widen(range, {source.at(x, y), source.at(x, y)});
            survey.cells.push_back(range);
            widen(survey.whole, range);
        }
    double across = 0.0, down = 0.0;  // the steepest steps
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            across = std::max(across, step(source.at(x, y), source.at(x + 1, y)));
            down = std::max(down, step(source.at(x, y), source.at(x, y + 1)));
        }
    if (!wraps) findLit(survey, width, height, source);
    const double range = step(survey.whole.max, survey.whole.min);
    if (range > 0.0) survey.detail = std::min({1.0, range / (across * width), range / (down * height)});
    return survey;
}

TextureSurvey surveyHalfFloatTexture(int width, int height, std::span<const glm::vec4> texels, bool wraps) {
    std::vector<glm::vec4> rounded;
    rounded.reserve(texels.size());
    for (const glm::vec4& texel : texels) rounded.push_back(glm::unpackHalf4x16(glm::packHalf4x16(texel)));
    return surveyTexture(width, height, rounded, wraps);
}

TextureRange rangeWithin(const TextureSurvey& survey, const glm::dvec2& min, const glm::dvec2& max) {
    const auto cell = [](double coordinate, int cells) {
        return static_cast<int>(std::clamp(std::floor(coordinate * cells), 0.0, cells - 1.0));
    };
    // Rounding in the shader's floats moves a coordinate by less than this.
    constexpr double margin = 1e-4;
    const int left = cell(min.x - margin, survey.columns), right = cell(max.x + margin, survey.columns);
    const int top = cell(min.y - margin, survey.rows), bottom = cell(max.y + margin, survey.rows);
    const auto at = [&](int column, int row) -> const TextureRange& {
        return survey.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(survey.columns) +
                            static_cast<std::size_t>(column)];
    };
    TextureRange range = at(left, top);
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column) widen(range, at(column, row));
    return range;
}

}  // namespace tyndall

// What a survey promises of a texture, against filtering done by hand.
#include <gtest/gtest.h>
#include <tyndall/texture_survey.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

struct Image {
    int width, height;
    std::vector<glm::vec4> texels;
};

Image randomImage(Random& random, int width, int height) {
    Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i) image.texels.push_back(glm::vec4(glm::dvec4(inCube(random, 1.0), 1.0)));
    return image;
}

// Bilinear filtering, texel centres at half texels.
glm::dvec3 filtered(const Image& image, glm::dvec2 uv, bool wraps) {
    const auto at = [&](int x, int y) {
        const auto place = [&](int i, int side) {
            return wraps ? ((i % side) + side) % side : std::clamp(i, 0, side - 1);
        };
        return glm::dvec3(image.texels.at(place(y, image.height) * image.width + place(x, image.width)));
    };
    const glm::dvec2 texel = uv * glm::dvec2(image.width, image.height) - 0.5;
    const glm::dvec2 corner = glm::floor(texel), share = texel - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    return glm::mix(glm::mix(at(x, y), at(x + 1, y), share.x), glm::mix(at(x, y + 1), at(x + 1, y + 1), share.x),
                    share.y);
}

// Doubles' own rounding.
constexpr double eps = 1e-12;

void expectWithin(const glm::dvec3& value, const TextureRange& range) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_GE(value[c], range.min[c] - eps);
        EXPECT_LE(value[c], range.max[c] + eps);
    }
}

TEST(TextureSurvey, BoundsEveryLookUp) {
    Random random(1);
    for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {5, 3}, {32, 32}, {33, 31}, {64, 100}, {129, 2}})
        for (const bool wraps : {false, true}) {
            const Image image = randomImage(random, width, height);
            const TextureSurvey survey = surveyTexture(width, height, image.texels, wraps);
            ASSERT_EQ(survey.cells.size(), static_cast<std::size_t>(survey.columns * survey.rows));
            for (int i = 0; i < 3000; ++i) {
                const glm::dvec2 uv(between(random, 0.0, 1.0), between(random, 0.0, 1.0));
                const glm::dvec3 value = filtered(image, uv, wraps);
                const int column = std::min(static_cast<int>(uv.x * survey.columns), survey.columns - 1);
                const int row = std::min(static_cast<int>(uv.y * survey.rows), survey.rows - 1);
                expectWithin(value, survey.cells.at(row * survey.columns + column));
                expectWithin(value, survey.whole);
            }
        }
}

TEST(TextureSurvey, IsNoWiderThanTheTexels) {
    Random random(2);
    const Image image = randomImage(random, 64, 64);
    const TextureSurvey survey = surveyTexture(64, 64, image.texels, false);
    glm::vec3 least(image.texels[0]), most(image.texels[0]);
    for (const glm::vec4& texel : image.texels) {
        least = glm::min(least, glm::vec3(texel));
        most = glm::max(most, glm::vec3(texel));
    }
    EXPECT_EQ(survey.whole.min, least);
    EXPECT_EQ(survey.whole.max, most);
    // A single bright texel in the middle of a cell of 8 x 8 shows in that cell alone.
    std::vector<glm::vec4> dark(256 * 256, glm::vec4(0.0f));
    dark[(8 * 5 + 4) * 256 + 8 * 3 + 4] = glm::vec4(1.0f);
    const TextureSurvey spot = surveyTexture(256, 256, dark, false);
    for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 32; ++column)
            EXPECT_EQ(spot.cells[row * 32 + column].max.r, row == 5 && column == 3 ? 1.0f : 0.0f);
}

TEST(TextureSurvey, RangeWithinHoldsWhatIsReadThere) {
    Random random(3);
    for (const auto& [width, height] : {std::pair(1, 1), {6, 4}, {40, 40}, {100, 70}}) {
        const Image image = randomImage(random, width, height);
        const TextureSurvey survey = surveyTexture(width, height, image.texels, false);
        for (int i = 0; i < 200; ++i) {
            // Clamped, so coordinates beyond the edge are fine.
            const glm::dvec2 a(between(random, -0.2, 1.2), between(random, -0.2, 1.2));
            const glm::dvec2 b(between(random, -0.2, 1.2), between(random, -0.2, 1.2));
            const glm::dvec2 least = glm::min(a, b), most = glm::max(a, b);
            const TextureRange range = rangeWithin(survey, least, most);
            for (int k = 0; k < 100; ++k)
                expectWithin(
                    filtered(image, {between(random, least.x, most.x), between(random, least.y, most.y)}, false),
                    range);
        }
    }
}

TEST(TextureSurvey, RangeWithinReadsNoMoreThanTheCellsMet) {
    std::vector<glm::vec4> halves;
    for (int i = 0; i < 64 * 64; ++i) halves.push_back(glm::vec4(i % 64 < 32 ? 1.0f : 0.0f));
    const TextureSurvey survey = surveyTexture(64, 64, halves, false);
    EXPECT_EQ(rangeWithin(survey, {0.0, 0.0}, {0.46, 1.0}).min.r, 1.0f);
    EXPECT_EQ(rangeWithin(survey, {0.54, 0.0}, {1.0, 1.0}).max.r, 0.0f);
    EXPECT_EQ(rangeWithin(survey, {0.46, 0.2}, {0.54, 0.3}).max.r, 1.0f);
}

TEST(TextureSurvey, DetailIsTheShareOfTheSideThatAFullChangeTakes) {
    const auto detail = [](int side, bool wraps, auto&& value) {
        std::vector<glm::vec4> texels;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) texels.push_back(glm::vec4(value(x, y)));
        return surveyTexture(side, side, texels, wraps).detail;
    };
    EXPECT_EQ(detail(16, false, [](int, int) { return 0.3f; }), 1.0) << "nothing in it";
    EXPECT_DOUBLE_EQ(detail(16, false, [](int x, int) { return x < 5 ? 0.0f : 1.0f; }), 1.0 / 16.0) << "a hard edge";
    EXPECT_DOUBLE_EQ(detail(16, false, [](int, int y) { return y < 5 ? 2.0f : 4.0f; }), 1.0 / 16.0) << "at any height";
    EXPECT_DOUBLE_EQ(detail(16, false, [](int x, int) { return 0.25f * static_cast<float>(std::min(x, 8)); }),
                     8.0 / 16.0)
        << "half the side";
    // 15 steps across, but one of full height where the texture repeats.
    const auto ramp = [](int x, int) { return static_cast<float>(x); };
    EXPECT_DOUBLE_EQ(detail(16, false, ramp), 15.0 / 16.0);
    EXPECT_DOUBLE_EQ(detail(16, true, ramp), 1.0 / 16.0);
}

// A texture of half floats holds other values than it was given: a survey of these alone would not bound what is drawn.
TEST(TextureSurvey, BoundsWhatHalfFloatsHold) {
    // 1 + 2^-12 is nearer to 1 than to the next half float, 1 + 2^-10; 1 + 3 * 2^-12 is nearer to that one.
    const float given[] = {1.0f + 0x1p-12f, 1.0f + 0x3p-12f, 1e-9f, 0.25f};
    const float held[] = {1.0f, 1.0f + 0x1p-10f, 0.0f, 0.25f};
    for (int i = 0; i < 4; ++i) {
        const glm::vec4 texel(given[i]);
        const TextureSurvey survey = surveyHalfFloatTexture(1, 1, std::span(&texel, 1), false);
        EXPECT_EQ(survey.whole.min, glm::vec3(held[i]));
        EXPECT_EQ(survey.whole.max, glm::vec3(held[i]));
    }
    Random random(5);
    const Image image = randomImage(random, 33, 31);
    const TextureSurvey rounded = surveyHalfFloatTexture(33, 31, image.texels, true),
                        given32 = surveyTexture(33, 31, image.texels, true);
    EXPECT_NE(rounded.whole.max, given32.whole.max);
    EXPECT_NEAR(rounded.whole.max.r, given32.whole.max.r, 0x1p-11);
    EXPECT_EQ(rounded.cells.size(), given32.cells.size());
}

}  // namespace
}  // namespace tyndall

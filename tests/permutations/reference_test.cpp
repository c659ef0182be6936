// Tier 3: with a growing number of slices, every permutation converges to the integral.
#include <study/reference.h>

#include <cmath>
#include <numbers>

#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

study::Image studyTexture(const Texture& texture) {
    return {texture.width, texture.height, texture.channels, texture.texels};
}

// The published constants as lengths of ray in metres: I and ambient for inches, 9 a hundred slices over the
// extent of depth, which all slices together represent.
void giveArticleConstants(Light& light, double depthExtent) {
    light.intensity = 20000.0 * 0.0254 * 0.0254;
    light.ambient = 0.25;
    light.anisotropy = 0.0;
    light.albedo.reset();
    light.density = 4.0 * std::numbers::pi * 900.0 / depthExtent;
    if (light.noise)
        light.noise->gain = 0.05;
    else
        light.density *= 0.015;
}

study::ReferenceScene referenceScene(const Shot& shot, double depthExtent) {
    study::ReferenceScene scene;
    scene.mode = study::Mode::Hardware;
    scene.view = viewOf(shot);
    scene.width = shot.width;
    scene.height = shot.height;
    scene.time = shot.time;
    scene.shadowBias = shot.shadowBias;
    scene.depth = studyTexture(shot.sceneDepth);
    scene.lights.resize(1);
    scene.lights[0].light = shot.light;
    scene.lights[0].cookie = studyTexture(shot.cookieMap);
    scene.lights[0].noise = studyTexture(shot.noiseMap);
    scene.lights[0].shadowMap = studyTexture(shot.shadowMap);
    if (shot.article) giveArticleConstants(scene.lights[0].light, depthExtent);
    return scene;
}

// The expected pixels. The published weights count depth, not the ray's length.
std::vector<glm::dvec3> truth(const Shot& shot, double depthExtent) {
    auto image = study::reference(referenceScene(shot, depthExtent));
    if (!image) throw std::runtime_error(image.error().message);
    if (shot.article)
        for (int y = 0; y < shot.height; ++y)
            for (int x = 0; x < shot.width; ++x)
                image->radiance[static_cast<std::size_t>(y) * shot.width + x] /=
                    glm::length(pixelRay(shot, x + 0.5, y + 0.5).perMetre);
    return std::move(image->radiance);
}

double relativeL2(const Picture& picture, const std::vector<glm::dvec3>& exact) {
    double error = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double difference = static_cast<double>(picture.pixels[i][c]) - exact[i][c];
            error += difference * difference;
            sum += exact[i][c] * exact[i][c];
        }
    return std::sqrt(error / sum);
}

struct Case {
    Permutation permutation;
    NamedShot shot;
};

std::vector<Case> referenceCases() {
    std::vector<Case> all;
    for (const Permutation& permutation : predictedPermutations())
        for (const NamedShot& shot : shots()) {
            if (shot.name.starts_with("side_")) continue;  // these differ only in the number of slices
            if (shot.shot.article && !permutation.drawsTheArticle()) continue;
            const bool everyTerm = permutation.terms == TermSet::all();
            if (!everyTerm && shot.name != "side" && shot.name != "surface" && shot.name != "article_look") continue;
            all.push_back({permutation, {shot.name, shotFor(permutation, shot.shot)}});
        }
    return all;
}

class ReferenceTest : public GpuTest, public testing::WithParamInterface<Case> {};
INSTANTIATE_TEST_SUITE_P(SlicesFx, ReferenceTest, testing::ValuesIn(referenceCases()), [](const auto& test) {
    return test.param.permutation.name() + "_" + std::string(test.param.shot.name);
});

// Every ray begins and ends at a jump, a side of the volume or a shadow's edge, and slices at the middles of slabs miss
// a jump by up to half a slab of it (Koksma: the error is at most half a slab times the total variation). So four
// times the slices leave a quarter of the error. Not quite: a rasterizer puts corners on a grid of 1/256 pixel, and
// rays that run along a side of the volume see slices there, or not, independently of their number; so the bound of the
// second step is weaker. The test detects a factor of 1.002 anywhere, or of 1.005 with scattering, whose phase and
// transmittance make a ray's jumps up to twice as large beside its integral in these shots.
TEST_P(ReferenceTest, SlicesCloseInOnTheIntegral) {
    Shot shot = GetParam().shot.shot;
    std::vector<double> errors;
    std::vector<glm::dvec3> exact;
    for (const int slices : {100, 400, 1600}) {
        shot.slices = slices;
        const Drawing drawing = draw(shot, optionsFor(GetParam().permutation));
        ASSERT_EQ(whyNotFinite(drawing.sum), "");
        ASSERT_EQ(drawing.plan.lights.at(0).terms, GetParam().permutation.terms);
        if (exact.empty()) exact = truth(shot, drawing.plan.lights[0].farDepth - drawing.plan.lights[0].nearDepth);
        errors.push_back(relativeL2(drawing.sum, exact));
    }
    for (std::size_t i = 0; i < errors.size(); ++i)
        RecordProperty("relative_l2_" + std::to_string(i), std::to_string(errors[i]));
    const double jumps = GetParam().permutation.terms.contains(Term::Scattering) ? 2.0 : 1.0;
    EXPECT_LT(errors[0], 0.06 * jumps);
    EXPECT_LT(errors[1], errors[0] / 3.0);
    EXPECT_LT(errors[2], errors[1] / 1.9);
    EXPECT_LT(errors[2], 0.003 * jumps);
}

}  // namespace
}  // namespace tyndall::test

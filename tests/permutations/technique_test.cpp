// Every technique of slices.fx whose terms determine its picture, drawn on lavapipe in every shot, lies within the
// oracle's intervals.
#include <cmath>

#include "draw.h"
#include "judge.h"

namespace tyndall::test {
namespace {

class TechniqueTest : public GpuTest, public testing::WithParamInterface<Permutation> {};

INSTANTIATE_TEST_SUITE_P(SlicesFx, TechniqueTest, testing::ValuesIn(predictedPermutations()), PermutationName());

Drawing drawInsideOracle(const NamedShot& named, const OracleImage& expected, const Permutation& permutation,
                         Geometry geometry) {
    const Shot& shot = named.shot;
    DrawOptions options = optionsFor(permutation);
    options.geometry = geometry;
    Drawing drawing = draw(shot, options);

    const PlannedLight& light = drawing.plan.lights.at(0);
    EXPECT_EQ(light.terms, permutation.terms);
    // Both computed in double precision, from corners of the same volume.
    EXPECT_NEAR(light.nearDepth, expected.nearDepth, 1e-9 * expected.farDepth);
    EXPECT_NEAR(light.farDepth, expected.farDepth, 1e-9 * expected.farDepth);

    const std::vector<Allowed> allowed = allowedBy(expected);
    EXPECT_LT(vagueness(allowed), 0.06);
    judgeOracle(permutation, "oracle, " + named.name + (geometry == Geometry::ExactPolygons ? ", polygons" : ", quads"),
                drawing.sum, drawing.plan.scale, allowed);
    EXPECT_GT(litPixels(drawing.sum), 500);
    return drawing;
}

// plan() names techniques without reading the effect; both must agree. The effect may have more.
TEST(Techniques, EveryOneThatPlanCanNameIsThereAndOfOneModule) {
    const permgen::Effect& effect = effectTables();
    const permgen::Technique* first = permgen::find_technique(effect, techniqueName({}));
    ASSERT_NE(first, nullptr);
    for (const TermSet terms : allTermSets) {
        const std::string_view name = techniqueName(terms);
        const permgen::Technique* technique = permgen::find_technique(effect, name);
        ASSERT_NE(technique, nullptr) << name;
        EXPECT_EQ(technique->passes[0].pixel.module, first->passes[0].pixel.module) << name;
        EXPECT_EQ(technique->passes[0].vertex.module, first->passes[0].vertex.module) << name;
    }
}

// If no slice's edge and no shadow comparison is undecided, the two geometries differ only by rounding.
TEST_P(TechniqueTest, BothGeometriesMatchTheOracleAndEachOther) {
    for (const NamedShot& named : shots()) {
        if (named.shot.article && !GetParam().drawsTheArticle()) continue;
        SCOPED_TRACE(named.name);
        NamedShot mine{named.name, shotFor(GetParam(), named.shot)};
        const Drawing polygons = drawInsideOracle(mine, oracle(mine.shot), GetParam(), Geometry::ExactPolygons);
        mine.shot.quads = true;
        const OracleImage expected = oracle(mine.shot);
        const Drawing quads = drawInsideOracle(mine, expected, GetParam(), Geometry::StretchedQuads);

        int apart = 0;
        for (std::size_t i = 0; i < expected.pixels.size(); ++i)
            for (int c = 0; c < 4; ++c) {
                const Interval& allowed = expected.pixels[i].rgba[c];
                const double difference = static_cast<double>(polygons.sum.pixels[i][c]) - quads.sum.pixels[i][c];
                apart += !(std::abs(difference) <= allowed.hi - allowed.lo);
            }
        EXPECT_EQ(apart, 0);
    }
}

// Forwards and backwards, from nearly even to a narrow peak, in thin and thick air.
class ScatteringTest : public GpuTest {};

TEST_F(ScatteringTest, OfEveryStrengthMatchesTheOracle) {
    for (const Permutation& permutation : predictedPermutations()) {
        if (permutation.terms != TermSet{Term::Scattering}) continue;
        for (NamedShot named : shots()) {
            if (named.name != "side" && named.name != "orthographic" && named.name != "towards_lamp") continue;
            for (const double g : {-0.95, -0.4, 0.1, 0.9})
                for (const double albedo : {0.0, 1.0, 0.1}) {
                    SCOPED_TRACE(named.name + ", g " + std::to_string(g) + ", albedo " + std::to_string(albedo));
                    Shot shot = shotFor(permutation, named.shot);
                    shot.light.anisotropy = g;
                    shot.light.albedo.reset();
                    if (albedo > 0.0) shot.light.albedo = albedo;
                    drawInsideOracle({named.name, shot}, oracle(shot), permutation, Geometry::ExactPolygons);
                }
        }
    }
}

}  // namespace
}  // namespace tyndall::test

// Every technique of slices.fx, drawn on lavapipe in every shot, lies inside what the oracle allows.
#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

class TechniqueTest : public GpuTest, public testing::WithParamInterface<Permutation> {};

INSTANTIATE_TEST_SUITE_P(SlicesFx, TechniqueTest, testing::ValuesIn(permutations()), PermutationName());

void expectInsideOracle(const Permutation& permutation, const NamedShot& named, Geometry geometry) {
    SCOPED_TRACE(named.name);
    Shot shot = shotFor(permutation, named.shot);
    shot.quads = geometry == Geometry::StretchedQuads;
    const OracleImage expected = oracle(shot);
    DrawOptions options;
    options.geometry = geometry;
    const Drawing drawing = draw(shot, options);

    const PlannedLight& light = drawing.plan.lights.at(0);
    EXPECT_EQ(light.technique, permutation.technique->name);
    // Both computed in double precision, from corners of the same volume.
    EXPECT_NEAR(light.nearDepth, expected.nearDepth, 1e-9 * expected.farDepth);
    EXPECT_NEAR(light.farDepth, expected.farDepth, 1e-9 * expected.farDepth);

    const std::vector<Allowed> allowed = allowedBy(expected);
    EXPECT_LT(vagueness(allowed), 0.06);
    EXPECT_EQ(whyOutside(drawing.sum, drawing.plan.scale, allowed), "");
    EXPECT_GT(litPixels(drawing.sum), 500);
}

TEST(Techniques, AreTheEightSettingsOfThreeSwitchesOverOneModule) {
    const std::vector<Permutation> all = permutations();
    ASSERT_EQ(all.size(), 8u);
    for (int bits = 0; bits < 8; ++bits) {
        const Permutation one = permutation((bits & 4) != 0, (bits & 2) != 0, (bits & 1) != 0);
        EXPECT_EQ(one.technique->name, techniqueName(one.noise, one.shadow, one.cookie));
        EXPECT_EQ(one.pass().pixel.module, all[0].pass().pixel.module);
        EXPECT_EQ(one.pass().vertex.module, all[0].pass().vertex.module);
    }
}

TEST_P(TechniqueTest, PolygonsMatchTheOracle) {
    for (const NamedShot& named : shots()) expectInsideOracle(GetParam(), named, Geometry::ExactPolygons);
}

TEST_P(TechniqueTest, StretchedQuadsMatchTheOracle) {
    for (const NamedShot& named : shots()) expectInsideOracle(GetParam(), named, Geometry::StretchedQuads);
}

// Wherever no slice's edge or shadow comparison is in doubt, the two geometries differ by rounding alone:
// both lie in the quads' interval. Summed over the picture, doubtful pixels included, they agree much closer.
TEST_P(TechniqueTest, BothGeometriesAgree) {
    for (const NamedShot& named : shots()) {
        SCOPED_TRACE(named.name);
        Shot shot = shotFor(GetParam(), named.shot);
        shot.quads = true;
        const OracleImage expected = oracle(shot);
        DrawOptions quads;
        quads.geometry = Geometry::StretchedQuads;
        const Drawing a = draw(shot), b = draw(shot, quads);
        ASSERT_EQ(whyNotFinite(a.sum), "");
        ASSERT_EQ(whyNotFinite(b.sum), "");
        EXPECT_EQ(a.plan.lights[0].nearDepth, b.plan.lights[0].nearDepth);
        EXPECT_EQ(a.plan.lights[0].farDepth, b.plan.lights[0].farDepth);
        int apart = 0;
        for (std::size_t i = 0; i < expected.pixels.size(); ++i)
            for (int c = 0; c < 4; ++c)
                if (std::abs(static_cast<double>(a.sum.pixels[i][c]) - b.sum.pixels[i][c]) >
                    expected.pixels[i].rgba[c].hi - expected.pixels[i].rgba[c].lo)
                    ++apart;
        EXPECT_EQ(apart, 0);
    }
}

}  // namespace
}  // namespace tyndall::test

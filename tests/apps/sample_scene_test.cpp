// The scenes in apps/scenes match their README.
#include <gtest/gtest.h>
#include <tyndall/scene/load_scene.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

namespace tyndall::test {
namespace {

struct Sample {
    const char* name;
    std::size_t lights;
    std::ptrdiff_t off;     ///< lights of intensity 0
    std::size_t noisy;      ///< lights with noise
    std::size_t maxImages;  ///< images of all lights and meshes together
    double loop;            ///< seconds after which the animation repeats; 0: nothing moves
    std::vector<std::string> cameras;
};

void PrintTo(const Sample& sample, std::ostream* out) {
    *out << sample.name;
}

class SampleScene : public testing::TestWithParam<Sample> {
protected:
    static std::string path() { return std::string(TYNDALL_SCENES "/") + GetParam().name + ".glb"; }
    static app::Scene load(double time) {
        auto scene = app::loadScene(path(), time);
        EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
        return scene ? std::move(*scene) : app::Scene{};
    }
};

TEST_P(SampleScene, HoldsItsLights) {
    const app::Scene scene = load(0.0);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    EXPECT_TRUE(scene.ignoredLights.empty());
    ASSERT_EQ(scene.lights.size(), GetParam().lights);
    EXPECT_EQ(std::ranges::count(scene.lights, 0.0, [](const auto& lamp) { return lamp.light.intensity; }),
              GetParam().off);
    EXPECT_EQ(static_cast<std::size_t>(
                  std::ranges::count_if(scene.lights, [](const auto& lamp) { return lamp.light.noise.has_value(); })),
              GetParam().noisy);
    EXPECT_LE(scene.images.size(), GetParam().maxImages) << "lights share their pictures";
}

TEST_P(SampleScene, HoldsItsCameras) {
    std::vector<std::string> names;
    for (const app::Camera& camera : load(0.0).cameras) names.push_back(camera.name);
    std::ranges::sort(names);
    EXPECT_EQ(names, GetParam().cameras);
}

TEST_P(SampleScene, FitsIntoAMegabyte) {
    EXPECT_LE(std::filesystem::file_size(path()), 1'000'000u);
}

/// The largest distance that a corner of a mesh's bounds moves between two moments.
double movement(const app::Scene& a, const app::Scene& b) {
    EXPECT_EQ(a.instances.size(), b.instances.size());
    double max = 0.0;
    for (std::size_t i = 0; i < std::min(a.instances.size(), b.instances.size()); ++i)
        for (const app::Vertex& vertex : a.meshes[a.instances[i].mesh].vertices) {
            const glm::dvec4 point(glm::dvec3(vertex.position), 1.0);
            max = std::max(max,
                           glm::distance(a.instances[i].worldFromMesh * point, b.instances[i].worldFromMesh * point));
        }
    return max;
}

TEST_P(SampleScene, MovesAndComesBack) {
    const double loop = GetParam().loop;
    const app::Scene start = load(0.0);
    if (loop == 0.0) {
        EXPECT_EQ(movement(start, load(1.0)), 0.0);
        return;
    }
    EXPECT_GT(movement(start, load(loop / 3.0)), 0.05) << "metres";
    // Keys are floats: 6e-8 of a turn's quaternion, twice that as an angle, on parts within 10 m of their pivot.
    EXPECT_LT(movement(start, load(loop)), 1e-5) << "metres";
}

INSTANTIATE_TEST_SUITE_P(
    All, SampleScene,
    testing::Values(Sample{"window", 3, 0, 1, 5, 125.0 / 24, {"Along the arcade", "Hall", "Inside the beam"}},
                    Sample{"stage", 32, 7, 3, 12, 0.0, {"Above", "Among the dancers", "Stalls", "Wings"}},
                    Sample{"cogs", 2, 0, 1, 3, 24.0, {"At the teeth", "Before the wheels", "Beside the shafts"}},
                    Sample{"street", 201, 0, 0, 4, 0.0, {"Across", "Roof", "Street"}}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tyndall::test

// Scenes loaded from valid glTF files.
#include <gtest/gtest.h>
#include <tyndall/scene/load_scene.h>

#include <numbers>

#include "glb.h"

namespace tyndall::test {
namespace {

app::Scene load(const Glb& glb, double time = 0.0) {
    auto scene = app::loadScene(writeScene(glb), time);
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? std::move(*scene) : app::Scene{};
}

constexpr double degree = std::numbers::pi / 180.0;

TEST(LoadScene, ReadsWallCameraAndLamp) {
    const app::Scene scene = load(wallScene());
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].indices.size(), 6u);
    EXPECT_EQ(scene.meshes[0].vertices[0].normal, glm::vec3(0, 0, 1)) << "computed from the triangles";
    EXPECT_EQ(scene.bounds.minimum, glm::dvec3(-4, -4, -5));
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].name, "Eye");
    EXPECT_DOUBLE_EQ(scene.cameras[0].verticalFov, 0.7);
    EXPECT_TRUE(std::isinf(scene.cameras[0].farPlane)) << "without zfar, the far plane is at infinity";
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(LoadScene, LampWithoutExtrasTakesTheDefaults) {
    const app::SceneLight lamp = load(wallScene()).lights.at(0);
    EXPECT_EQ(lamp.light.name, "Lamp");
    EXPECT_DOUBLE_EQ(lamp.light.fov.x, 0.7) << "twice the outer cone angle";
    EXPECT_DOUBLE_EQ(lamp.light.fov.y, 0.7);
    EXPECT_DOUBLE_EQ(lamp.light.nearPlane, 0.05);
    EXPECT_NEAR(lamp.light.farPlane, 5.0 * 1.01, 1e-12) << "the scene's extent and a little";
    EXPECT_DOUBLE_EQ(lamp.light.density, 0.02);
    EXPECT_DOUBLE_EQ(lamp.light.intensity, 100.0);
    EXPECT_TRUE(lamp.light.shadow);
    EXPECT_FALSE(lamp.light.noise);
    EXPECT_TRUE(lamp.light.cookie) << "the cone's falloff";
}

TEST(LoadScene, ConeFalloffIsBakedIntoTheCookie) {
    const app::Scene scene = load(wallScene());
    const Image& cookie = scene.images.at(*scene.lights[0].cookie);
    EXPECT_FLOAT_EQ(rgbaOf(cookie, cookie.width * (cookie.height / 2) + cookie.width / 2).r, 1.0f) << "centre";
    EXPECT_EQ(rgbaOf(cookie, 0).r, 0.0f) << "corner, outside the cone";
    // Half way between the angles: ((cos a - cos outer) / (cos inner - cos outer))^2, KHR_lights_punctual.
    const double angle = 0.275;
    const double column = (std::tan(angle) / std::tan(0.35) + 1.0) / 2.0 * cookie.width;
    const double share = (std::cos(angle) - std::cos(0.35)) / (std::cos(0.2) - std::cos(0.35));
    const auto texel = static_cast<std::size_t>(column);
    // A texel spans 2 tan(0.35) / 512 = 1.4e-3 in slope; the falloff's steepness there is 2 share sin(a) /
    // (cos inner - cos outer) < 7, so a texel away is within 0.01.
    EXPECT_NEAR(rgbaOf(cookie, cookie.width * (cookie.height / 2) + texel).r, share * share, 0.01);
}

TEST(LoadScene, ExtrasSayEverythingElse) {
    Glb glb = wallScene();
    const std::size_t cookie = glb.addTexture(2, 1, {255, 0, 0, 255, 188, 188, 188, 255});
    glb.json["nodes"][2]["extras"]["tyndall"] = {
        {"shape", "frustum"},
        {"fov", {40, 20}},
        {"near", 0.5},
        {"far", 7},
        {"cookie", cookie},
        {"shadow", "none"},
        {"noise", {{"texture", cookie}, {"scale", {4, 5}}, {"scroll1", {1, 2}}, {"scroll2", {3, 4}}, {"gain", 6}}},
        {"density", 0.5},
        {"ambient", 0.25},
        {"anisotropy", -0.5},
        {"albedo", 0.8},
        {"clipPlanes", {{0, 2, 0, 4}}}};
    const app::Scene scene = load(glb);
    const app::SceneLight& lamp = scene.lights.at(0);
    EXPECT_DOUBLE_EQ(lamp.light.fov.x, 40 * degree);
    EXPECT_DOUBLE_EQ(lamp.light.fov.y, 20 * degree);
    EXPECT_DOUBLE_EQ(lamp.light.nearPlane, 0.5);
    EXPECT_DOUBLE_EQ(lamp.light.farPlane, 7.0);
    EXPECT_FALSE(lamp.light.shadow);
    EXPECT_DOUBLE_EQ(lamp.light.density, 0.5);
    EXPECT_DOUBLE_EQ(lamp.light.ambient, 0.25);
    EXPECT_DOUBLE_EQ(lamp.light.anisotropy, -0.5);
    EXPECT_DOUBLE_EQ(lamp.light.albedo.value_or(0.0), 0.8);
    ASSERT_EQ(lamp.light.clipPlanes.size(), 1u);
    EXPECT_EQ(lamp.light.clipPlanes[0], glm::dvec4(0, 1, 0, 2)) << "normalized";
    ASSERT_TRUE(lamp.light.noise);
    EXPECT_EQ(lamp.light.noise->scale, glm::dvec2(4, 5));
    EXPECT_EQ(lamp.light.noise->scroll1, glm::dvec2(1, 2));
    EXPECT_EQ(lamp.light.noise->scroll2, glm::dvec2(3, 4));
    EXPECT_DOUBLE_EQ(lamp.light.noise->gain, 6.0);
    const Image& slide = scene.images.at(*lamp.cookie);
    ASSERT_EQ(slide.width, 2u) << "a frustum's cookie is the given picture";
    EXPECT_FLOAT_EQ(rgbaOf(slide, 0).r, 1.0f);
    EXPECT_NEAR(rgbaOf(slide, 1).g, 0.5029, 1e-4) << "sRGB 188 is about half as linear light";
    EXPECT_NEAR(rgbaOf(scene.images.at(*lamp.noise), 1).g, 188.0 / 255.0, 1e-6) << "noise is data, not colour";
}

/// Lamps beside the wall scene's own, each with these extras.
void addLamps(Glb& glb, int count, const nlohmann::json& extras, int light = 0) {
    for (int i = 0; i < count; ++i)
        glb.addNode({{"name", "Other"},
                     {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}},
                     {"extras", {{"tyndall", extras}}}});
}

TEST(LoadScene, EqualConesAreBakedOnce) {
    Glb glb = wallScene();
    addLamps(glb, 199, nlohmann::json::object());
    const app::Scene scene = load(glb);
    ASSERT_EQ(scene.lights.size(), 200u);
    EXPECT_EQ(scene.images.size(), 1u);
    for (const app::SceneLight& lamp : scene.lights) EXPECT_EQ(lamp.cookie, 0u);
}

TEST(LoadScene, ConesThatDifferInAngleOrCookieAreBakedEachForItself) {
    Glb glb = wallScene();  // inner 0.2, outer 0.35
    auto& lights = glb.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.35}}}});
    lights.push_back({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}}}});
    const std::size_t grey = glb.addTexture(1, 1, {188, 188, 188, 255});
    const std::size_t white = glb.addTexture(1, 1, {255, 255, 255, 255});
    for (const int light : {1, 2}) addLamps(glb, 2, nlohmann::json::object(), light);
    for (const std::size_t cookie : {grey, white}) addLamps(glb, 2, {{"cookie", cookie}});
    const app::Scene scene = load(glb);
    ASSERT_EQ(scene.lights.size(), 9u);
    EXPECT_EQ(scene.images.size(), 5u);
    EXPECT_EQ(scene.slides.size(), 2u) << "two cones were baked into each";
    for (std::size_t lamp = 1; lamp < 9; lamp += 2) EXPECT_EQ(scene.lights[lamp].cookie, scene.lights[lamp + 1].cookie);
    const auto centre = [&](std::size_t lamp) {
        const Image& cookie = scene.images.at(*scene.lights[lamp].cookie);
        return rgbaOf(cookie, cookie.width * (cookie.height / 2) + cookie.width / 2).r;
    };
    EXPECT_NEAR(centre(5), 0.5029f, 1e-4) << "sRGB 188 is about half as linear light";
    EXPECT_FLOAT_EQ(centre(7), 1.0f);
}

TEST(LoadScene, LightsAndMeshesShareTexturesButNotEncodings) {
    Glb glb = wallScene();
    const std::size_t texture = glb.addTexture(1, 1, {188, 188, 188, 255});
    glb.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}}};
    auto& primitive = glb.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["attributes"]["TEXCOORD_0"] = glb.addFloats({0, 0, 1, 0, 1, 1, 0, 1}, "VEC2");
    // Exporters give each user of an image a texture of its own.
    glb.json["textures"].push_back(glb.json["textures"][texture]);
    glb.json["nodes"][2]["extras"]["tyndall"] = {
        {"shape", "frustum"}, {"cookie", texture + 1}, {"noise", {{"texture", texture}}}};
    addLamps(glb, 3, glb.json["nodes"][2]["extras"]["tyndall"]);
    const app::Scene scene = load(glb);
    ASSERT_EQ(scene.lights.size(), 4u);
    EXPECT_EQ(scene.images.size(), 2u) << "once as colour, once as data";
    for (const app::SceneLight& lamp : scene.lights) {
        EXPECT_EQ(lamp.cookie, scene.meshes.at(0).material.baseTexture);
        EXPECT_NE(lamp.noise, lamp.cookie);
    }
}

TEST(LoadScene, TexturesThatNothingDrawnNamesAreLeftAlone) {
    Glb glb = wallScene();
    const std::size_t used = glb.addTexture(1, 1, {255, 255, 255, 255});
    glb.json["nodes"][2]["extras"]["tyndall"] = {{"shape", "frustum"}, {"cookie", used}};
    glb.addTexture(4, 4, std::vector<std::uint8_t>(64, 200));
    const std::size_t noPicture = glb.addView(std::vector<unsigned char>(16, 7));
    glb.json["images"].push_back({{"bufferView", noPicture}, {"mimeType", "image/png"}});
    glb.json["textures"].push_back({{"source", glb.json["images"].size() - 1}});
    // A mesh with the broken texture that no node shows.
    glb.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", glb.json["textures"].size() - 1}}}}}}};
    glb.json["meshes"].push_back(glb.json["meshes"][0]);
    glb.json["meshes"][1]["primitives"][0]["material"] = 0;
    const app::Scene scene = load(glb);
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].width, 1u);
    EXPECT_TRUE(scene.slides.empty());
}

TEST(LoadScene, FrustumWithoutCookieHasNone) {
    Glb glb = wallScene();
    glb.json["nodes"][2]["extras"]["tyndall"] = {{"shape", "frustum"}};
    const app::Scene scene = load(glb);
    EXPECT_FALSE(scene.lights.at(0).light.cookie);
    EXPECT_DOUBLE_EQ(scene.lights[0].light.fov.x, 0.7);
}

TEST(LoadScene, ExtrasOfTheNodeAboveCountForALampTurnedByTheExporter) {
    Glb glb = wallScene();
    glb.json["nodes"].push_back({{"name", "Stand"}, {"children", {2}}, {"extras", {{"tyndall", {{"density", 0.7}}}}}});
    glb.json["scenes"][0]["nodes"] = {0, 1, 3};
    EXPECT_DOUBLE_EQ(load(glb).lights.at(0).light.density, 0.7);
}

TEST(LoadScene, ScaleIsTakenOutOfLightAndCameraPoses) {
    Glb glb = wallScene();
    for (const int node : {1, 2}) {
        glb.json["nodes"][node]["scale"] = {3, 0.5, 2};
        glb.json["nodes"][node]["rotation"] = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};  // 90 degrees about +Y
        glb.json["nodes"][node]["translation"] = {1, 2, 3};
    }
    const app::Scene scene = load(glb);
    for (const glm::dmat4& pose : {scene.cameras.at(0).worldFromCamera, scene.lights.at(0).light.worldFromLight}) {
        EXPECT_NEAR(glm::determinant(pose), 1.0, 1e-12);
        const glm::dvec3 forward = -glm::dvec3(pose[2]);
        EXPECT_NEAR(glm::distance(forward, glm::dvec3(-1, 0, 0)), 0.0, 1e-9);
        EXPECT_EQ(glm::dvec3(pose[3]), glm::dvec3(1, 2, 3));
    }
}

TEST(LoadScene, UnknownKeysAreNamedInAWarning) {
    Glb glb = wallScene();
    glb.json["nodes"][2]["extras"]["tyndall"] = {{"densty", 0.5}};
    const app::Scene scene = load(glb);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("\"densty\""), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[0].find("density"), std::string::npos) << "lists the known keys: " << scene.warnings[0];
}

TEST(LoadScene, PointAndDirectionalLightsAreReportedWithTheReason) {
    Glb glb = wallScene();
    auto& lights = glb.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"type", "point"}});
    lights.push_back({{"type", "directional"}});
    for (const int light : {1, 2})
        glb.addNode({{"name", "Other"}, {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
    const app::Scene scene = load(glb);
    EXPECT_EQ(scene.lights.size(), 1u);
    ASSERT_EQ(scene.ignoredLights.size(), 2u);
    EXPECT_NE(scene.ignoredLights[0].reason.find("point light"), std::string::npos);
    EXPECT_NE(scene.ignoredLights[1].reason.find("directional light"), std::string::npos);
}

struct Interpolation {
    const char* name;
    std::vector<float> values;
    double at1;  ///< x after one of two seconds
};

class LoadSceneAnimation : public testing::TestWithParam<Interpolation> {};

TEST_P(LoadSceneAnimation, MovesTheCamera) {
    Glb glb = wallScene();
    const std::size_t times = glb.addFloats({0, 2}, "SCALAR");
    const std::size_t values = glb.addFloats(GetParam().values, "VEC3");
    glb.json["animations"] = {
        {{"samplers", {{{"input", times}, {"output", values}, {"interpolation", GetParam().name}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
    EXPECT_NEAR(load(glb, 1.0).cameras.at(0).worldFromCamera[3].x, GetParam().at1, 1e-6);
    EXPECT_NEAR(load(glb, 9.0).cameras.at(0).worldFromCamera[3].x, 4.0, 1e-6) << "held after the last key";
    EXPECT_NEAR(load(glb, -9.0).cameras.at(0).worldFromCamera[3].x, 0.0, 1e-6) << "and before the first";
}

// Cubic: h00 0.5 * 0 + span * h10 (0.125) * out 2 + h01 0.5 * 4 + span * h11 (-0.125) * in 0 = 0.5 + 2.
INSTANTIATE_TEST_SUITE_P(
    All, LoadSceneAnimation,
    testing::Values(Interpolation{"LINEAR", {0, 0, 0, 4, 0, 0}, 2.0}, Interpolation{"STEP", {0, 0, 0, 4, 0, 0}, 0.0},
                    Interpolation{"CUBICSPLINE", {0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0}, 2.5}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(LoadScene, RotationsTurnTheShortWay) {
    Glb glb = wallScene();
    const std::size_t times = glb.addFloats({0, 1}, "SCALAR");
    const float half = std::sqrt(0.5f);
    const std::size_t values = glb.addFloats({0, 0, 0, 1, 0, half, 0, half}, "VEC4");
    glb.json["animations"] = {{{"samplers", {{{"input", times}, {"output", values}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}}}}}};
    const glm::dmat4 pose = load(glb, 0.5).cameras.at(0).worldFromCamera;
    EXPECT_NEAR(pose[2].x, std::sin(45 * degree), 1e-6);
    EXPECT_NEAR(pose[2].z, std::cos(45 * degree), 1e-6);
}

TEST(LoadScene, StripsAndFansBecomeTheSameSquare) {
    for (const int mode : {5, 6}) {
        Glb glb = wallScene();
        auto& primitive = glb.json["meshes"][0]["primitives"][0];
        primitive["mode"] = mode;
        primitive["indices"] =
            glb.addIndices(mode == 5 ? std::vector<std::uint16_t>{0, 1, 3, 2} : std::vector<std::uint16_t>{0, 1, 2, 3});
        const app::Scene scene = load(glb);
        EXPECT_EQ(scene.meshes.at(0).indices.size(), 6u);
        for (const app::Vertex& vertex : scene.meshes[0].vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1)) << mode;
    }
}

TEST(LoadScene, OrthographicCameraKeepsItsHeight) {
    Glb glb = wallScene();
    glb.json["cameras"][0] = {{"type", "orthographic"},
                              {"orthographic", {{"xmag", 9}, {"ymag", 2}, {"znear", 0.5}, {"zfar", 40}}}};
    const app::Camera camera = load(glb).cameras.at(0);
    EXPECT_TRUE(camera.orthographic);
    EXPECT_DOUBLE_EQ(camera.halfHeight, 2.0);
    EXPECT_DOUBLE_EQ(camera.farPlane, 40.0);
}

}  // namespace
}  // namespace tyndall::test

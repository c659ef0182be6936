// Broken scenes: each gives one sentence that names the place, no crash, no hang.
#include <gtest/gtest.h>
#include <tyndall/scene/load_scene.h>

#include <array>
#include <functional>

#include "glb.h"

namespace tyndall::test {
namespace {

struct Breakage {
    const char* name;
    std::function<void(Glb&)> apply;
    const char* says;  ///< what the sentence must contain
};

nlohmann::json& lampExtras(Glb& glb) {
    return glb.json["nodes"][2]["extras"]["tyndall"];
}
nlohmann::json& primitive(Glb& glb) {
    return glb.json["meshes"][0]["primitives"][0];
}

const std::vector<Breakage>& breakages() {
    static const std::vector<Breakage> all = {
        {"NoCamera", [](Glb& g) { g.json["nodes"][1].erase("camera"); }, "no camera"},
        {"NoLight", [](Glb& g) { g.json["nodes"][2].erase("extensions"); }, "no light"},
        {"CookieOutOfRange",
         [](Glb& g) {
             lampExtras(g) = {{"cookie", 3}};
         },
         "texture 3, but the file has 0"},
        {"CookieNegative",
         [](Glb& g) {
             lampExtras(g) = {{"cookie", -1}};
         },
         "index of a texture"},
        {"NoiseOutOfRange",
         [](Glb& g) {
             lampExtras(g) = {{"noise", {{"texture", 9}}}};
         },
         "texture 9"},
        {"NoiseWithoutTexture",
         [](Glb& g) {
             lampExtras(g) = {{"noise", {{"gain", 1}}}};
         },
         "at least a \"texture\""},
        {"ExtrasNoObject", [](Glb& g) { lampExtras(g) = "dense"; }, "must be an object"},
        {"ShapeUnknown",
         [](Glb& g) {
             lampExtras(g) = {{"shape", "sphere"}};
         },
         "\"cone\" or \"frustum\""},
        {"ShadowUnknown",
         [](Glb& g) {
             lampExtras(g) = {{"shadow", true}};
         },
         "\"static\""},
        {"FovNoPair",
         [](Glb& g) {
             lampExtras(g) = {{"fov", {40}}};
         },
         "two numbers"},
        {"FovZero",
         [](Glb& g) {
             lampExtras(g) = {{"shape", "frustum"}, {"fov", {0, 40}}};
         },
         "0 degrees"},
        {"FovStraight",
         [](Glb& g) {
             lampExtras(g) = {{"shape", "frustum"}, {"fov", {40, 180}}};
         },
         "180 degrees"},
        {"ConeZero",
         [](Glb& g) {
             auto& spot = g.json["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"];
             spot = {{"innerConeAngle", 0.0}, {"outerConeAngle", 0.0}};
         },
         "0 degrees"},
        {"ConeInsideOut",
         [](Glb& g) { g.json["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"]["innerConeAngle"] = 0.5; },
         "inner cone angle"},
        {"NearBeyondFar",
         [](Glb& g) {
             lampExtras(g) = {{"near", 9}, {"far", 2}};
         },
         "beyond its far plane"},
        {"NearZero",
         [](Glb& g) {
             lampExtras(g) = {{"near", 0}};
         },
         "above 0"},
        {"DensityNegative",
         [](Glb& g) {
             lampExtras(g) = {{"density", -1}};
         },
         "density"},
        {"AnisotropyOne",
         [](Glb& g) {
             lampExtras(g) = {{"anisotropy", 1}};
         },
         "anisotropy"},
        {"AlbedoZero",
         [](Glb& g) {
             lampExtras(g) = {{"albedo", 0}};
         },
         "albedo"},
        {"AlbedoOverOne",
         [](Glb& g) {
             lampExtras(g) = {{"albedo", 1.5}};
         },
         "albedo"},
        {"DensityText",
         [](Glb& g) {
             lampExtras(g) = {{"density", "thick"}};
         },
         "a number"},
        {"ClipPlaneWithoutDirection",
         [](Glb& g) {
             lampExtras(g) = {{"clipPlanes", {{0, 0, 0, 1}}}};
         },
         "clipPlanes"},
        {"ClipPlanesTooMany",
         [](Glb& g) {
             lampExtras(g) = {{"clipPlanes", nlohmann::json(7, nlohmann::json{0, 1, 0, 0})}};
         },
         "at most 6"},
        {"LightIndex", [](Glb& g) { g.json["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = 4; },
         "but the file has 1 lights"},
        {"TranslationShort",
         [](Glb& g) {
             g.json["nodes"][0]["translation"] = {1, 2};
         },
         "nodes[0].translation must be 3"},
        {"RotationLong",
         [](Glb& g) {
             g.json["nodes"][1]["rotation"] = {0, 0, 0, 1, 0};
         },
         "nodes[1].rotation must be 4 numbers, but is 5"},
        {"RotationNothing",
         [](Glb& g) {
             g.json["nodes"][1]["rotation"] = {0, 0, 0, 0};
         },
         "nodes[1].rotation is all zeros"},
        {"ScaleOfWords",
         [](Glb& g) {
             g.json["nodes"][2]["scale"] = {"1", "1", "1"};
         },
         "nodes[2].scale must be 3 numbers, but is something else"},
        {"MatrixShort",
         [](Glb& g) {
             g.json["nodes"][0]["matrix"] = {1, 0, 0, 0};
         },
         "nodes[0].matrix must be 16"},
        {"CameraFlattened",
         [](Glb& g) {
             g.json["nodes"][1]["scale"] = {0, 1, 1};
         },
         "scaled to nothing"},
        {"OrthographicWithoutWidth",
         [](Glb& g) {
             g.json["cameras"][0] = {{"type", "orthographic"},
                                     {"orthographic", {{"xmag", 0}, {"ymag", 2}, {"znear", 0.5}, {"zfar", 40}}}};
         },
         "width or a height of 0"},
        {"ModeUnknown", [](Glb& g) { primitive(g)["mode"] = 7; }, "primitives[0].mode is 7"},
        {"LampScaledToNothing",
         [](Glb& g) {
             g.json["nodes"][2]["scale"] = {0, 0, 0};
         },
         "scaled to nothing"},
        {"CameraFovZero", [](Glb& g) { g.json["cameras"][0]["perspective"]["yfov"] = 0; }, "field of view"},
        {"CameraFovStraight", [](Glb& g) { g.json["cameras"][0]["perspective"]["yfov"] = 3.14159265358979324; }, "180"},
        {"CameraNearBeyondFar", [](Glb& g) { g.json["cameras"][0]["perspective"]["zfar"] = 0.05; },
         "beyond its far plane"},
        {"CameraNearZero", [](Glb& g) { g.json["cameras"][0]["perspective"]["znear"] = 0; }, "near plane"},
        {"CameraIndex", [](Glb& g) { g.json["nodes"][1]["camera"] = 1; }, "but the file has 1 cameras"},
        {"NodeBelowItself", [](Glb& g) { g.json["nodes"][0]["children"] = {0}; }, "own ancestor"},
        {"NodeCycle",
         [](Glb& g) {
             g.json["nodes"].push_back({{"children", {4}}});
             g.json["nodes"].push_back({{"children", {3}}});
         },
         "own ancestor"},
        {"NodeWithTwoParents",
         [](Glb& g) {
             g.json["nodes"][0]["children"] = {2};
             g.json["nodes"][1]["children"] = {2};
         },
         "one parent"},
        {"ChildIndex", [](Glb& g) { g.json["nodes"][0]["children"] = {77}; }, "but the file has 3 nodes"},
        {"SceneNodeIndex", [](Glb& g) { g.json["scenes"][0]["nodes"] = {5}; }, "but the file has 3 nodes"},
        {"SceneIndex", [](Glb& g) { g.json["scene"] = 2; }, "but the file has 1 scenes"},
        {"MeshIndex", [](Glb& g) { g.json["nodes"][0]["mesh"] = 1; }, "but the file has 1 meshes"},
        {"MaterialIndex", [](Glb& g) { primitive(g)["material"] = 0; }, "but the file has 0 materials"},
        {"MaterialTextureIndex",
         [](Glb& g) {
             g.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 8}}}}}}};
             primitive(g)["material"] = 0;
         },
         "but the file has 0 textures"},
        {"AccessorIndex", [](Glb& g) { primitive(g)["attributes"]["POSITION"] = 99; }, "but the file has 3 accessors"},
        {"AccessorNegative", [](Glb& g) { primitive(g)["attributes"]["POSITION"] = -1; }, "accessors"},
        {"AccessorPastItsView", [](Glb& g) { g.json["accessors"][0]["count"] = 5; }, "accessors[0] has 5 elements"},
        {"AccessorCountHuge", [](Glb& g) { g.json["accessors"][0]["count"] = 4000000000u; }, "accessors[0]"},
        {"AccessorCountOverflowing", [](Glb& g) { g.json["accessors"][0]["count"] = 1ull << 62; }, "whole number"},
        {"AccessorCountZero", [](Glb& g) { g.json["accessors"][0]["count"] = 0; }, "at least 1"},
        {"AccessorOffset", [](Glb& g) { g.json["accessors"][0]["byteOffset"] = 4; }, "accessors[0]"},
        {"AccessorOffsetNegative", [](Glb& g) { g.json["accessors"][0]["byteOffset"] = -4; }, "whole number"},
        {"AccessorType", [](Glb& g) { g.json["accessors"][0]["type"] = "VEC9"; }, "unknown type"},
        {"AccessorComponents", [](Glb& g) { g.json["accessors"][0]["type"] = "VEC2"; }, "2 components instead of 3"},
        {"AccessorSparse",
         [](Glb& g) {
             g.json["accessors"][0]["sparse"] = {{"count", 1}};
         },
         "sparse"},
        {"AccessorViewIndex", [](Glb& g) { g.json["accessors"][0]["bufferView"] = 12; }, "buffer views"},
        {"ViewBufferIndex", [](Glb& g) { g.json["bufferViews"][0]["buffer"] = 1; }, "but the file has 1 buffers"},
        {"ViewPastItsBuffer", [](Glb& g) { g.json["bufferViews"][0]["byteLength"] = 100000; }, "bufferViews[0]"},
        {"ViewOffsetHuge", [](Glb& g) { g.json["bufferViews"][0]["byteOffset"] = 1ull << 52; }, "bufferViews[0]"},
        {"ViewStride", [](Glb& g) { g.json["bufferViews"][0]["byteStride"] = 1; }, "byteStride"},
        {"BufferLongerThanTheFile", [](Glb& g) { g.json["buffers"][0]["byteLength"] = 1 << 20; }, "binary chunk"},
        {"BufferFileMissing",
         [](Glb& g) {
             g.json["buffers"].push_back({{"byteLength", 4}, {"uri", "nowhere.bin"}});
         },
         "nowhere.bin"},
        {"ImageViewIndex",
         [](Glb& g) {
             g.json["images"] = {{{"bufferView", 40}, {"mimeType", "image/png"}}};
         },
         "buffer views"},
        {"ImageIsNoPicture",
         [](Glb& g) {
             g.json["images"] = {{{"bufferView", 0}, {"mimeType", "image/png"}}};
             g.json["textures"] = {{{"source", 0}}};
             lampExtras(g) = {{"cookie", 0}};
         },
         "neither PNG nor JPEG"},
        {"TextureWithoutImage",
         [](Glb& g) {
             g.json["textures"] = {nlohmann::json::object()};
             lampExtras(g) = {{"cookie", 0}};
         },
         "no PNG or JPEG image"},
        {"TextureFileMissing",
         [](Glb& g) {
             g.json["images"] = {{{"uri", "nowhere.png"}}};
             g.json["textures"] = {{{"source", 0}}};
             lampExtras(g) = {{"cookie", 0}};
         },
         "nowhere.png"},
        {"IndexPastTheVertices",
         [](Glb& g) {
             primitive(g)["indices"] = g.addIndices({0, 1, 4});
         },
         "vertex 4 of 4"},
        {"IndicesAreFloats",
         [](Glb& g) {
             primitive(g)["indices"] = g.addFloats({0, 1, 2}, "SCALAR");
         },
         "unsigned whole numbers"},
        {"NormalsTooFew",
         [](Glb& g) {
             primitive(g)["attributes"]["NORMAL"] = g.addFloats({0, 0, 1}, "VEC3");
         },
         "4 positions but 1"},
        {"NoPositions", [](Glb& g) { primitive(g)["attributes"].erase("POSITION"); }, "no positions"},
        {"PositionNan",
         [](Glb& g) {
             primitive(g)["attributes"] = {
                 {"POSITION", g.addFloats({0, 0, 0, 1, 0, 0, 1, std::nanf(""), 0, 0, 1, 0}, "VEC3")}};
         },
         "not finite"},
        {"PositionInfinite",
         [](Glb& g) {
             primitive(g)["attributes"] = {
                 {"POSITION", g.addFloats({0, 0, 0, 1, 0, 0, 1, INFINITY, 0, 0, 1, 0}, "VEC3")}};
         },
         "not finite"},
        {"TransformOverflows",
         [](Glb& g) {
             g.json["nodes"][0]["scale"] = {1e200, 1e200, 1e200};
             g.json["nodes"].push_back({{"children", {0}}, {"scale", {1e200, 1e200, 1e200}}});
             g.json["scenes"][0]["nodes"] = {1, 2, 3};
         },
         "not finite"},
        {"AnimationKeysBackwards",
         [](Glb& g) {
             const std::size_t times = g.addFloats({1, 0}, "SCALAR"), values = g.addFloats({0, 0, 0, 1, 1, 1}, "VEC3");
             g.json["animations"] = {
                 {{"samplers", {{{"input", times}, {"output", values}}}},
                  {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
         },
         "do not increase"},
        {"AnimationValuesMissing",
         [](Glb& g) {
             const std::size_t times = g.addFloats({0, 1}, "SCALAR"), values = g.addFloats({0, 0, 0}, "VEC3");
             g.json["animations"] = {
                 {{"samplers", {{{"input", times}, {"output", values}}}},
                  {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
         },
         "2 keys but 1 values"},
        {"AnimationSampler",
         [](Glb& g) {
             g.json["animations"] = {{{"samplers", nlohmann::json::array()}, {"channels", {{{"sampler", 3}}}}}};
         },
         "samplers in that animation"},
        {"RequiredExtension", [](Glb& g) { g.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "KHR_draco_mesh_compression"},
        {"NodesNoArray", [](Glb& g) { g.json["nodes"] = "none"; }, "\"nodes\" must be an array"},
        {"NodeNoObject", [](Glb& g) { g.json["nodes"][0] = 7; }, "nodes[0] must be an object"},
        {"AssetMissing", [](Glb& g) { g.json.erase("asset"); }, "asset"},
    };
    return all;
}

class BadScene : public testing::TestWithParam<std::size_t> {};

TEST_P(BadScene, SaysWhatIsWrong) {
    const Breakage& breakage = breakages()[GetParam()];
    Glb glb = wallScene();
    breakage.apply(glb);
    const auto scene = app::loadScene(writeScene(glb), 0.0);
    ASSERT_FALSE(scene) << "was read without an error";
    EXPECT_NE(scene.error().message.find(breakage.says), std::string::npos) << scene.error().message;
    EXPECT_NE(scene.error().message.find("scene.glb"), std::string::npos)
        << "names the file: " << scene.error().message;
    EXPECT_EQ(scene.error().message.find('\n'), std::string::npos) << scene.error().message;
}

INSTANTIATE_TEST_SUITE_P(All, BadScene, testing::Range<std::size_t>(0, breakages().size()),
                         [](const auto& test) { return std::string(breakages()[test.param].name); });

TEST(BadSceneFile, TruncatedAnywhere) {
    const std::vector<unsigned char> whole = wallScene().bytes();
    for (std::size_t size = 0; size < whole.size(); size += 3) {
        const auto scene = app::loadScene(writeBytes(std::span(whole).first(size), "cut.glb"), 0.0);
        ASSERT_FALSE(scene) << "the first " << size << " of " << whole.size() << " bytes were read as a whole scene";
        ASSERT_EQ(scene.error().message.find('\n'), std::string::npos) << scene.error().message;
    }
}

TEST(BadSceneFile, TruncatedJson) {
    Glb glb = wallScene();
    glb.json["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAA";
    const std::string whole = glb.json.dump();
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(whole.data());
        EXPECT_FALSE(app::loadScene(writeBytes({bytes, size}, "cut.gltf"), 0.0)) << size;
    }
}

/// Each byte in turn is changed: the result may be a scene or an error.
TEST(BadSceneFile, DamagedAnywhere) {
    const std::vector<unsigned char> whole = wallScene().bytes();
    for (std::size_t at = 0; at < whole.size(); at += 5)
        for (const unsigned char value : std::array<unsigned char, 5>{0x00, 0x22, 0x39, 0x7D, 0xFF}) {
            std::vector<unsigned char> damaged = whole;
            damaged[at] = value;
            const auto scene = app::loadScene(writeBytes(damaged, "damaged.glb"), 0.0);
            if (!scene) {
                ASSERT_FALSE(scene.error().message.empty()) << at;
            }
        }
}

TEST(BadSceneFile, NotThere) {
    const auto scene = app::loadScene(freshPath("nothing.glb"), 0.0);
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().message.find("no such file"), std::string::npos) << scene.error().message;
}

TEST(BadSceneFile, Folder) {
    const auto scene = app::loadScene("/", 0.0);
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().message.find("not a file"), std::string::npos) << scene.error().message;
}

TEST(BadSceneFile, NestedTooDeep) {
    const std::string deep =
        "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(200000, '[') + std::string(200000, ']') + "}";
    const auto scene = app::loadScene(
        writeBytes({reinterpret_cast<const unsigned char*>(deep.data()), deep.size()}, "deep.gltf"), 0.0);
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().message.find("nests too deep"), std::string::npos) << scene.error().message;
}

TEST(BadSceneFile, ImageThatClaimsToBeHuge) {
    Glb glb = wallScene();
    std::vector<unsigned char> png = encodePng(1, 1, {0, 0, 0, 0});
    png[16] = png[20] = 0x01;  // width and height of 16 777 217
    glb.addView(png);
    glb.json["images"] = {{{"bufferView", glb.json["bufferViews"].size() - 1}, {"mimeType", "image/png"}}};
    glb.json["textures"] = {{{"source", 0}}};
    lampExtras(glb) = {{"cookie", 0}};
    const auto scene = app::loadScene(writeScene(glb), 0.0);
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().message.find("16777217x16777217"), std::string::npos) << scene.error().message;
}

}  // namespace
}  // namespace tyndall::test

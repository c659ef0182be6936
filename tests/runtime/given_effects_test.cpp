// Builds of the runtime's effects that the caller gives: the same source gives the same picture, and an unsuitable
// build gives an error.
#include <composite.fx.h>
#include <permgen/manifest.h>
#include <shadow_map.fx.h>
#include <slices.fx.h>

#include <functional>

#include "record_scene.h"

namespace tyndall::test {
namespace {

using GivenEffects = GpuTest;

DeviceContext context() {
    DeviceContext context;
    context.physicalDevice = gpu().device.physicalDevice();
    context.device = gpu().device.device();
    return context;
}

permgen::LoadedEffect load(const std::string& name) {
    auto loaded = permgen::load_manifest(EFFECTS "/" + name + ".fx.json");
    if (!loaded) throw std::runtime_error(loaded.error().message);
    return std::move(*loaded);
}

std::vector<Rgba> picture(Renderer& renderer) {
    Stage stage;
    stage.setDepth([](std::uint32_t x, std::uint32_t) { return x > 30 ? 0.05f : 0.0f; });
    const Slides slides;
    Light light = lamp();
    light.cookie = light.shadow = true;
    light.noise.emplace();
    const Plan plan = must(tyndall::plan(std::span(&light, 1), eye(stage), PlanOptions{}));
    ShaftTargets targets = stage.targets();
    targets.blur = true;
    Stage half({48, 32}, Accumulation::Rgba16f);
    targets.accumulation = half.accumulation.handle();
    targets.accumulationView = half.accumulation.view();
    FrameData frame;
    must(renderer.upload(frame, plan));
    const LightTextures textures = slides.views();
    run([&](VkCommandBuffer commands) {
        return renderer.record(commands, frame, plan, std::span(&textures, 1), targets);
    });
    return stage.picture();
}

TEST_F(GivenEffects, LoadedAtRunTimeTheyDrawTheSamePicture) {
    const permgen::LoadedEffect slices = load("slices"), composite = load("composite"), shadowMap = load("shadow_map");
    Renderer builtIn = must(Renderer::create(context()));
    const std::vector<Rgba> expected = picture(builtIn);
    EXPECT_GT(*std::max_element(expected.begin(), expected.end()), (Rgba{0.001f, 0.0f, 0.0f, 0.0f}));
    for (const Shaders shaders : {Shaders::Frozen, Shaders::Specialized}) {
        DeviceContext given = context();
        given.shaders = shaders;
        given.slices = &slices.tables();
        given.composite = &composite.tables();
        given.shadowMap = &shadowMap.tables();
        Renderer renderer = must(Renderer::create(given));
        EXPECT_TRUE(picture(renderer) == expected);
    }
}

/// A copy of slices.fx's tables to spoil.
struct Spoilt {
    permgen::Effect effect = slices::effect;
    std::vector<permgen::Member> members{effect.members.begin(), effect.members.end()};
    std::vector<permgen::Resource> resources{effect.resources.begin(), effect.resources.end()};
    std::vector<permgen::Technique> techniques{effect.techniques.begin(), effect.techniques.end()};
    permgen::Pass pass = techniques[2].passes[0];
    permgen::Module vertex = *pass.vertex.module;
    std::vector<permgen::Attribute> attributes{vertex.attributes.begin(), vertex.attributes.end()};

    explicit Spoilt(const std::function<void(Spoilt&)>& spoil) {
        spoil(*this);
        vertex.attributes = attributes;
        effect.members = members;
        effect.resources = resources;
        effect.techniques = techniques;
    }
    Spoilt(const Spoilt&) = delete;
};

struct Misfit {
    const char* name;
    std::function<void(Spoilt&)> spoil;
    const char* says;
};

void PrintTo(const Misfit& misfit, std::ostream* out) {
    *out << misfit.name;
}

class MisfitTest : public GpuTest, public testing::WithParamInterface<Misfit> {};

TEST_P(MisfitTest, IsRefused) {
    const Spoilt spoilt(GetParam().spoil);
    DeviceContext given = context();
    given.slices = &spoilt.effect;
    const auto renderer = Renderer::create(given);
    ASSERT_FALSE(renderer);
    EXPECT_EQ(renderer.error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(renderer.error().message.rfind("the effect slices, given for slices.fx, ", 0), 0u);
    EXPECT_NE(renderer.error().message.find(GetParam().says), std::string::npos) << renderer.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    SlicesFx, MisfitTest,
    testing::Values(
        Misfit{"MemberMoved", [](Spoilt& s) { s.members[4].offset += 16; }, "has no constant gClipPlanes where"},
        Misfit{"MemberShrunk", [](Spoilt& s) { s.members[12].size = 12; }, "has no constant gShadow where"},
        Misfit{"MemberGone", [](Spoilt& s) { s.members.pop_back(); }, "has no constant gEye where"},
        Misfit{"MemberMore",
               [](Spoilt& s) {
                   s.members.push_back({"Globals", "gMore", 0, 4});
               },
               "does not write"},
        Misfit{"BlockLonger", [](Spoilt& s) { s.resources[0].size += 16; }, "does not write"},
        Misfit{"SamplerMore", [](Spoilt& s) { s.resources[1].name = "Extra"; }, "reads Extra, which"},
        Misfit{"SamplerOfCube", [](Spoilt& s) { s.resources[1].dimension = permgen::ImageDimension::Cube; }, "reads "},
        Misfit{"TechniqueGone", [](Spoilt& s) { s.techniques.erase(s.techniques.begin() + 3); },
               "has no technique clip_noise_noshadow_nocookie_technique"},
        Misfit{"NoPass", [](Spoilt& s) { s.techniques[0].passes = {}; },
               "has 0 passes in clip_noise_shadow_cookie_technique"},
        Misfit{"NoPixelShader",
               [](Spoilt& s) {
                   s.pass.pixel = {};
                   s.techniques[2].passes = std::span(&s.pass, 1);
               },
               "lacks a shader in clip_noise_noshadow_cookie_technique"},
        Misfit{"NotFrozen",
               [](Spoilt& s) {
                   s.pass.pixel.frozen = {};
                   s.techniques[2].passes = std::span(&s.pass, 1);
               },
               "has no frozen modules"},
        Misfit{"UnknownSemantic",
               [](Spoilt& s) {
                   s.attributes[0].semantic = "NORMAL0";
                   s.pass.vertex.module = &s.vertex;
                   s.techniques[2].passes = std::span(&s.pass, 1);
               },
               "reads NORMAL0 in clip_noise_noshadow_cookie_technique"}),
    [](const auto& misfit) { return std::string(misfit.param.name); });

TEST_F(GivenEffects, EachIsHeldToItsOwnContract) {
    DeviceContext given = context();
    given.composite = &slices::effect;
    EXPECT_NE(Renderer::create(given).error().message.find("given for composite.fx, has no constant gTint"),
              std::string::npos);
    given = context();
    given.shadowMap = &composite::effect;
    EXPECT_NE(Renderer::create(given).error().message.find("given for shadow_map.fx, has no constant gClipFromMesh"),
              std::string::npos);
    given = context();
    given.slices = &shadow_map::effect;
    EXPECT_NE(Renderer::create(given).error().message.find("given for slices.fx, has no constant gClipFromView"),
              std::string::npos);
}

}  // namespace
}  // namespace tyndall::test

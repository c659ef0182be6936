// Uses every part of tyndall::plan that an engine uses: it surveys a scene, plans a frame and explains the plan. Every
// header of the library compiles without Vulkan.
#include <every_header.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#ifdef VK_VERSION_1_0
#error "a header of tyndall::plan includes Vulkan"
#endif

namespace {

int fail(const std::string& sentence) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    return 1;
}

}  // namespace

int main() {
    const tyndall::Light light;
    const tyndall::View view = tyndall::perspectiveView(glm::dmat4(1.0), 0.8, 1.0, 0.1, 100.0);

    // A square of a metre, 5 m before the lamp.
    const std::array<glm::vec3, 4> corners{
        {{-0.5f, -0.5f, -5.0f}, {0.5f, -0.5f, -5.0f}, {0.5f, 0.5f, -5.0f}, {-0.5f, 0.5f, -5.0f}}};
    const std::array<std::uint32_t, 6> indices{0, 1, 2, 0, 2, 3};
    const tyndall::MeshTriangles square{.positions = corners.data(), .vertices = corners.size(), .indices = indices};
    const tyndall::MeshInstance instance;
    const auto occluders = tyndall::OccluderSet::fromMeshes(std::span(&square, 1), std::span(&instance, 1));
    if (!occluders) return fail(occluders.error().message);
    const auto blockers = tyndall::BlockerSet::fromMeshes(std::span(&square, 1), std::span(&instance, 1));
    if (!blockers) return fail(blockers.error().message);

    const std::vector<float> empty(16 * 16, 0.0f);  // reversed depth: no surface
    tyndall::DepthSurvey depth;
    if (const auto surveyed = tyndall::surveyDepth(empty, 16, 16, view, depth); !surveyed)
        return fail(surveyed.error().message);
    const std::vector<glm::vec4> white(4 * 4, glm::vec4(1.0f));
    const tyndall::TextureSurvey cookie = tyndall::surveyTexture(4, 4, white, false);
    const tyndall::LightSurvey survey{.cookie = &cookie};

    tyndall::Planner planner;
    tyndall::Plan plan;
    const tyndall::Surroundings surroundings{
        .occluders = &*occluders, .blockers = &*blockers, .depth = depth.asTiles(), .surveys = std::span(&survey, 1)};
    if (const auto planned = planner.plan(std::span(&light, 1), view, {}, surroundings, plan); !planned)
        return fail(planned.error().message);
    if (plan.lights.size() != 1 || !plan.lights[0].drawn) return fail("the light is not drawn");
    if (!plan.lights[0].terms.contains(tyndall::Term::Shadow)) return fail("the square throws no shadow");

    tyndall::ShadowCache cache;
    const tyndall::ShadowCaster caster{.geometry = {1}};
    const std::span casters(&caster, 1);
    if (!tyndall::mayShade(light, glm::dmat4(1.0), {{-0.5, -0.5, -5.0}, {0.5, 0.5, -5.0}}))
        return fail("the square is outside of the light");
    if (!cache.stale(0, light, casters, 1024)) return fail("a map that was never drawn is not stale");
    cache.drawn(0, light, casters, 1024);
    if (cache.stale(0, light, casters, 1024)) return fail("a map that was drawn is stale");
    if (tyndall::extinction(light) != 0.0) return fail("clear air absorbs light");

    const std::string why = tyndall::reason(plan.lights[0], view);
    std::printf("%s\n", why.c_str());
    return why.empty() ? fail("no sentence explains the plan") : 0;
}

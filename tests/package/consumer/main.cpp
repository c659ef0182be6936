#include <permgen/manifest.h>
#include <tint.fx.h>
#include <tyndall/plan.h>

#include <cstdio>

// Reads the tables at compile time, like an engine that must know the needs of each technique before the first frame.
static_assert(tint::effect.techniques.size() == 2);
static_assert(!permgen::is_live(permgen::find_technique(tint::effect, "plain")->passes[0], "PictureSampler"));
static_assert(permgen::is_live(permgen::find_technique(tint::effect, "picture")->passes[0], "PictureSampler"));

int main() {
    // And at run time, like an engine that reloads edited effects.
    const auto loaded = permgen::load_manifest(EFFECTS);
    if (!loaded || loaded->tables().techniques.size() != tint::effect.techniques.size()) {
        std::fprintf(stderr, "%s\n", loaded ? "another number of techniques" : loaded.error().message.c_str());
        return 1;
    }

    const tyndall::Light light;
    const tyndall::View view = tyndall::perspectiveView(glm::dmat4(1.0), 0.8, 1.0, 0.1, 100.0);
    const auto plan = tyndall::plan(std::span(&light, 1), view, {});
    if (!plan) {
        std::fprintf(stderr, "%s\n", plan.error().message.c_str());
        return 1;
    }
    return plan->lights.size() == 1 && plan->lights[0].drawn ? 0 : 1;
}

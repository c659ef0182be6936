// Plans a frame and explains the plan. Every installed header of tyndall::plan compiles without Vulkan.
#include <tyndall/explain.h>
#include <tyndall/light.h>
#include <tyndall/plan.h>
#include <tyndall/shadow_cache.h>
#include <tyndall/surroundings.h>
#include <tyndall/texture_survey.h>
#include <tyndall/view.h>

#include <cstdio>

#ifdef VK_VERSION_1_0
#error "a header of tyndall::plan includes Vulkan"
#endif

int main() {
    const tyndall::Light light;
    const tyndall::View view = tyndall::perspectiveView(glm::dmat4(1.0), 0.8, 1.0, 0.1, 100.0);
    const auto plan = tyndall::plan(std::span(&light, 1), view, {});
    if (!plan) {
        std::fprintf(stderr, "%s\n", plan.error().message.c_str());
        return 1;
    }
    if (plan->lights.size() != 1 || !plan->lights[0].drawn) return 1;
    const std::string why = tyndall::reason(plan->lights[0], view);
    std::printf("%s\n", why.c_str());
    return why.empty() ? 1 : 0;
}

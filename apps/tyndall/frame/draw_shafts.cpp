#include "draw_shafts.h"

#include <headless/commands.h>

namespace tyndall::app {

bool isBlurred(const Plan& plan) {
    return plan.accumulation == Accumulation::Rgba8 || plan.accumulation == Accumulation::Rgba8Routed;
}

std::vector<LightTextures> texturesOf(const PlannedScene& planned, const ShadowMaps& maps, const GpuScene& gpu) {
    const Scene& scene = planned.scene;
    std::vector<LightTextures> textures(scene.lights.size());
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const SceneLight& light = scene.lights[i];
        textures[i] = {.cookie = light.cookie ? gpu.images[*light.cookie].view() : VK_NULL_HANDLE,
                       .noise = light.noise ? gpu.images[*light.noise].view() : VK_NULL_HANDLE,
                       .shadowMap = maps.view(i),
                       .shadowHierarchy = maps.hierarchy(i),
                       .cookieSize = light.cookie ? gpu.images[*light.cookie].extent() : VkExtent2D{},
                       .noiseSize = light.noise ? gpu.images[*light.noise].extent() : VkExtent2D{}};
    }
    return textures;
}

Result<void> drawShafts(const headless::Device& device, Renderer& renderer, FrameData& frame, const Plan& plan,
                        std::span<const LightTextures> textures, const FrameTargets& targets, bool measure,
                        headless::FragmentCounter* counter, FrameStatistics& statistics) {
    const ShaftTargets shafts{.extent = targets.colour.extent(),
                              .accumulation = targets.accumulation.handle(),
                              .accumulationView = targets.accumulation.view(),
                              .storage = targets.storage,
                              .depth = targets.depth.view(),
                              .depthFormat = depthFormat,
                              .colour = targets.colour.view(),
                              .colourFormat = colourFormat,
                              .blur = isBlurred(plan)};
    for (std::size_t group = 0; group < plan.groups.size(); ++group) {
        for (int round = measure ? 0 : 1; round < 2; ++round) {
            const bool counted = round == 1 && counter;
            const RendererCounters before = renderer.counters();
            auto added = headless::submitAndWait(device, [&](VkCommandBuffer commands) {
                if (counted) counter->begin(commands);
                auto recorded = renderer.recordAccumulation(commands, frame, plan, group, textures, shafts);
                if (counted) counter->end(commands);
                return recorded;
            });
            if (!added) return passOn(added.error(), "the shafts");
            if (round == 0) continue;
            statistics.accumulate += *added;
            statistics.shafts.draws += renderer.counters().draws - before.draws;
            statistics.shafts.slicesDrawn += renderer.counters().slicesDrawn - before.slicesDrawn;
        }
        if (counter) {
            auto fragments = passOn(counter->invocations(), "counting fragments");
            if (!fragments) return tl::unexpected(fragments.error());
            statistics.fragments += *fragments;
        }
        auto composited = headless::submitAndWait(device, [&](VkCommandBuffer commands) {
            headless::fullBarrier(commands);
            return renderer.recordComposite(commands, frame, plan, group, shafts);
        });
        if (!composited) return passOn(composited.error(), "the shafts");
        statistics.composite += *composited;
    }
    return {};
}

}  // namespace tyndall::app

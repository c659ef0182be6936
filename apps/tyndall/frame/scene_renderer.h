// Draws a scene frame after frame. Each frame pays for what is new in it: meshes are uploaded once, and so is each
// picture, when something drawn first uses it; shadow maps are drawn where what they show has moved; pipelines are made
// when a technique is first called for; targets and working memory stay.
#pragma once

#include <headless/statistics.h>
#include <kit/image/image.h>
#include <tyndall/pass_pipelines.h>

#include <limits>

#include "frame_statistics.h"
#include "frame_targets.h"
#include "gpu_scene.h"
#include "plan_scene.h"
#include "shadow_maps.h"
#include "surfaces.h"

namespace tyndall::app {

struct Frame {
    Image picture;
    FrameStatistics statistics;
};

class SceneRenderer {
public:
    /// For `scene` as it was loaded. Between frames its camera, lights and instances may move and change; its meshes,
    /// pictures, and which of them is used where, may not. `device` outlives the renderer, and so does `cache`, which
    /// pipelines are made with and which may be null.
    static Result<SceneRenderer> create(const headless::Device& device, const Scene& scene,
                                         VkPipelineCache cache = VK_NULL_HANDLE);

    /// Draws `planned` as it stands: updates what is known of the scene, draws the surfaces, and plans with their depth
    /// and exposure. `measure` adds the slices twice and times the second, so that no compilation is in
    /// the figure.
    Result<Frame> draw(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts, bool measure);

    /// draw() up to the plan.
    Result<void> plan(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts);

    /// The parts of draw(), for what needs no more of it. `lights` has one entry for each of viewed.lights; those that
    /// call for a shadow map get one where surfaces are lit.
    Result<void> drawSurfaces(const ViewedScene& viewed, std::span<const SurfaceLight> lights, Size size,
                               std::uint32_t shadowSize, bool lit);
    Result<void> drawShadowMaps(const ViewedScene& viewed, std::span<const std::size_t> lights,
                                 std::uint32_t shadowSize);

    const FrameTargets& targets() const { return targets_; }
    const ShadowMaps& shadowMaps() const { return maps_; }

private:
    SceneRenderer(const headless::Device& device, Renderer renderer, PassPipelines pipelines, GpuScene gpu)
        : device_(&device),
          renderer_(std::move(renderer)),
          surfacePipelines_(std::move(pipelines)),
          gpu_(std::move(gpu)) {}

    Result<void> planAsDrawn(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts,
                              double maxStep);
    Result<void> drawPlanned(PlannedScene& planned, const ShaftOptions& shafts, bool measure);
    Result<void> preparePipelines(const Plan& plan);
    void startFrame();
    void finishStatistics();

    const headless::Device* device_;
    Renderer renderer_;
    PassPipelines surfacePipelines_;
    GpuScene gpu_;
    ShadowMaps maps_;
    SurfacePass surfaces_;
    FrameTargets targets_;
    FrameData shaftData_;
    headless::FragmentCounter counter_;
    bool counts_ = false;  ///< counter_ is there

    FrameStatistics frame_;  ///< of the frame that is being drawn
    struct Before {
        RendererCounters shafts;
        std::uint64_t surfacePipelines = 0, images = 0, imageBytes = 0;
    } before_;  ///< counters when it began
};

}  // namespace tyndall::app

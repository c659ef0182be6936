// Draws a scene frame after frame. Each frame does only the work that is new: meshes are uploaded once, each image at
// its first use; a shadow map is drawn again when an instance in it has moved; pipelines are made at a technique's
// first use; targets and working memory stay.
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
    /// For `scene` as it was loaded. Between frames its camera, lights and instances may move and change, but not its
    /// meshes, its images and their users. Pipelines are made with `cache`, which may be null. `device` and `cache`
    /// must outlive the renderer.
    static Result<SceneRenderer> create(const headless::Device& device, const Scene& scene,
                                        VkPipelineCache cache = VK_NULL_HANDLE);

    /// Draws `planned`: updates the facts about the scene, draws the surfaces, and plans with their depth and exposure.
    /// `measure` adds the slices twice and times the second, so that the time has no compilation in it.
    Result<Frame> draw(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts, bool measure);

    /// draw() up to the plan.
    Result<void> plan(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts);

    /// The parts of draw(). `lights` has one entry for each of viewed.lights; those that need a shadow map get one if
    /// surfaces are lit.
    Result<void> drawSurfaces(const ViewedScene& viewed, std::span<const SurfaceLight> lights, Size size,
                              std::uint32_t shadowSize, bool lit);
    Result<void> drawShadowMaps(const ViewedScene& viewed, std::span<const std::size_t> lights,
                                std::uint32_t shadowSize, bool hierarchies);

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

    FrameStatistics frame_;  ///< of the current frame
    struct Before {
        RendererCounters shafts;
        std::uint64_t surfacePipelines = 0, images = 0, imageBytes = 0;
    } before_;  ///< counters at its start
};

}  // namespace tyndall::app

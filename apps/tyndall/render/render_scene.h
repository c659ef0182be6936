// A planned scene drawn on a device, and read back.
#pragma once

#include <headless/device.h>
#include <tyndall/renderer.h>

#include <limits>

#include "../image/picture.h"
#include "../plan/plan_scene.h"
#include "drawn_scene.h"

namespace tyndall::app {

/// What a frame took. Times in milliseconds from submission to fence, by the host's clock.
struct FrameStatistics {
    double pipelines = 0.0;  ///< making the shafts' pipelines
    double shadowMaps = 0.0, surfaces = 0.0, accumulate = 0.0, composite = 0.0;
    std::uint64_t fragments = 0;  ///< shaded while slices were added, rounded up by some drivers
    bool fragmentsKnown = false;  ///< false where the device does not count
    RendererCounters shafts;
    std::uint64_t imagesUploaded = 0, imageBytes = 0;  ///< textures, cookies and noise, of surfaces and shafts
    std::uint64_t surfaceDraws = 0, surfacePipelines = 0;
    std::uint64_t deviceBytes = 0;     ///< most device memory held at once
    std::uint64_t frameDataBytes = 0;  ///< of that, the slices' vertices, indices and constants
};

struct Frame {
    Picture picture;
    FrameStatistics statistics;
};

/// Draws all that shafts are drawn from, and plans anew with the depth and the exposure that come of it. Nothing is
/// left out for a display whose step is above `mostStep`, in radiance.
Outcome<DrawnScene> drawPlanned(const headless::Device& device, Renderer& renderer, PlannedScene& planned,
                                const ViewOptions& view, const ShaftOptions& shafts, VkPipelineCache cache,
                                double mostStep = std::numeric_limits<double>::infinity());

/// Draws `planned` (whose plan is made anew once the depth of the scene is known). `measure` adds the
/// slices twice and times the second, so that no compilation is in the figure. Pipelines are made with `cache`,
/// which may be null.
Outcome<Frame> renderScene(const headless::Device& device, PlannedScene& planned, const ViewOptions& view,
                           const ShaftOptions& shafts, bool measure, VkPipelineCache cache = VK_NULL_HANDLE);

}  // namespace tyndall::app

// The data of a Renderer, shared by the files that implement its functions.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "frame_data.h"
#include "gpu_context.h"
#include "neutral_textures.h"
#include "pipelines.h"

namespace tyndall {

struct Renderer::Impl {
    Gpu gpu;
    const permgen::Effect *slices = nullptr, *raycast = nullptr, *composite = nullptr, *shadowMap = nullptr,
                          *shadowHierarchy = nullptr;
    /// Of `slices` and `raycast`, by TermSet::index().
    std::array<const permgen::Technique*, TermSet::count> sliceTechniques{}, raycastTechniques{};
    PipelineStore pipelines;
    NeutralTextures neutral;
    RendererCounters counters;

    /// A part of the group being recorded, resolved before rendering begins.
    struct PartDraw {
        const PlannedPart* part = nullptr;
        PassPipeline pipeline;
        FrameRange constants;
        VkDeviceSize constantsSize = 0;
        std::array<NamedImage, 6> images{};
        bool computed = false;  ///< by compute_rays.h, with these threads
        VkExtent2D threads{};
    };
    std::vector<PartDraw> draws;  ///< kept between calls for its capacity

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl();
};

/// The frame's data, tied to this device on first use.
/// Errors: InvalidArgument for a frame that was moved from or belongs to another device.
Result<FrameData::Impl*> useFrame(const Gpu& gpu, FrameData::Impl* frame);

/// Copies one value and counts its bytes.
template <class Value>
Result<FrameRange> placeValue(FrameData::Impl& frame, const Value& value, RendererCounters& counters) {
    counters.bytesUploaded += sizeof value;
    return place(frame, std::as_bytes(std::span(&value, 1)));
}

void bindVertices(VkCommandBuffer commands, VkBuffer buffer, VkDeviceSize offset, VkDeviceSize stride);

/// Errors: InvalidArgument if the targets are incomplete, the group is not in the plan, or the frame does not hold this
/// plan.
Result<void> checkRecording(const FrameData::Impl& frame, const Plan& plan, std::size_t group,
                            const ShaftTargets& targets);

}  // namespace tyndall

// Records a plan into the caller's command buffer. All decisions are in the plan.
//
// The caller owns instance, device, queues, memory of its own images, synchronization between frames and
// the pipeline cache. device.h says what the device needs. Nothing here is thread-safe: use one Renderer per thread, or
// a lock.
#pragma once

#include <tyndall/device.h>
#include <tyndall/parallel.h>
#include <tyndall/plan.h>
#include <tyndall/result.h>
#include <tyndall/shadow_cache.h>
#include <vulkan/vulkan_core.h>

#include <memory>
#include <span>

namespace tyndall {

VkFormat accumulationFormat(Accumulation accumulation);

/// Red holds the smallest and green the largest stored depth of a block of the shadow map.
inline constexpr VkFormat shadowHierarchyFormat = VK_FORMAT_R32G32_SFLOAT;

/// The textures of one light, in layout SHADER_READ_ONLY_OPTIMAL. Views that its technique does not read may be null;
/// they are not bound. A neutral texture replaces a null view that it does read: white for cookie and noise, an empty
/// shadow map.
struct LightTextures {
    VkImageView cookie = VK_NULL_HANDLE;     ///< linear colour
    VkImageView noise = VK_NULL_HANDLE;      ///< red and green hold the two maps
    VkImageView shadowMap = VK_NULL_HANDLE;  ///< depth aspect of a map drawn with lightClipFromLight()
    // For Method::Raycast.
    VkImageView shadowHierarchy = VK_NULL_HANDLE;  ///< all levels that recordShadowHierarchy() made of the shadow map;
                                                   ///< required with a shadow map
    VkExtent2D cookieSize{}, noiseSize{};          ///< texels, of the textures that are given
};

/// The images that a plan is drawn to. All have one size and one sample per pixel.
struct ShaftTargets {
    VkExtent2D extent{};
    VkImage accumulation = VK_NULL_HANDLE;  ///< of accumulationFormat(), usage COLOR_ATTACHMENT | SAMPLED
    VkImageView accumulationView = VK_NULL_HANDLE;
    bool storage = false;  ///< the accumulation image also has the usage STORAGE: in the two float formats
                           ///< Method::Raycast then computes instead of drawing, which some devices do many times
                           ///< faster. The command buffer's queue must compute, and the barriers before record() must
                           ///< cover compute shaders
    VkImageView depth = VK_NULL_HANDLE;  ///< the scene's, read only, layout DEPTH_READ_ONLY_OPTIMAL (both
                                         ///< tested against and sampled: by the blur, and by Method::Raycast, whose
                                         ///< fragment or compute shader reads it); usage
                                         ///< DEPTH_STENCIL_ATTACHMENT | SAMPLED. Null: no surface hides the shafts, and
                                         ///< there is no blur
    VkFormat depthFormat = VK_FORMAT_UNDEFINED;
    VkCompareOp depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL;  ///< reversed depth as in perspectiveView()
    VkImageView colour = VK_NULL_HANDLE;  ///< shafts are added to it, layout COLOR_ATTACHMENT_OPTIMAL
    VkFormat colourFormat = VK_FORMAT_UNDEFINED;
    bool blur = false;  ///< compositing blurs 3x3 and stops at depth edges
};

/// The image of a shadow hierarchy: shadowHierarchyFormat, shadowHierarchySide() texels a side,
/// shadowHierarchyLevels() mip levels (raycast_data.h), usage COLOR_ATTACHMENT | SAMPLED.
struct ShadowHierarchy {
    VkImage image = VK_NULL_HANDLE;
    std::span<const VkImageView> levels;  ///< a view of each level
};

/// One occluder: indexed triangles, positions as three floats at the start of each vertex.
struct Occluder {
    VkBuffer vertices = VK_NULL_HANDLE;
    VkDeviceSize vertexOffset = 0;
    std::uint32_t vertexStride = 12;    ///< bytes, a multiple of 4
    VkBuffer indices = VK_NULL_HANDLE;  ///< 32-bit
    VkDeviceSize indexOffset = 0;
    std::uint32_t indexCount = 0;
    glm::dmat4 worldFromMesh{1.0};
};

/// The occluder for a ShadowCache: identified by its buffers' handles and offsets. If a buffer's contents change, or a
/// new buffer may have the handle of a destroyed one, invalidate() the cache.
ShadowCaster shadowCaster(const Occluder& occluder);

/// What will be recorded: everything that pipelines depend on.
struct PipelineNeeds {
    std::span<const TermSet> terms;  ///< of the parts to be drawn with `method`; may repeat
    Method method = Method::Slices;
    Accumulation accumulation = Accumulation::Rgba16f;
    VkFormat depthFormat = VK_FORMAT_UNDEFINED;  ///< as in ShaftTargets; UNDEFINED if its depth will be null
    VkCompareOp depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL;
    VkFormat colourFormat = VK_FORMAT_UNDEFINED;  ///< as in ShaftTargets; UNDEFINED: nothing is composited
    bool blur = false;
    VkFormat shadowMapFormat = VK_FORMAT_UNDEFINED;  ///< UNDEFINED: no shadow map is drawn
    bool storage = false;                            ///< as in ShaftTargets
};

/// Counters of one Renderer since its creation.
struct RendererCounters {
    std::uint64_t draws = 0, slicesDrawn = 0, descriptorsPushed = 0, pipelinesCreated = 0, bytesUploaded = 0;
    std::uint64_t neutralTexturesCreated = 0;
    std::uint64_t shadowMapsDrawn = 0, shadowHierarchiesDrawn = 0;
    std::uint64_t pipelinesPrepared = 0;  ///< the part of pipelinesCreated that prepare() made
};

/// GPU memory that one frame in flight needs: vertices, indices, constants. Grows as needed and never shrinks. Reuse it
/// only after the GPU has finished with it. Destroy it before the device.
class FrameData {
public:
    struct Impl;  ///< the library's own
    FrameData();
    FrameData(FrameData&&) noexcept;
    FrameData& operator=(FrameData&&) noexcept;
    ~FrameData();
    /// Bytes of device memory held.
    VkDeviceSize memory() const;

private:
    friend class Renderer;
    std::unique_ptr<Impl> impl_;
};

class Renderer {
public:
    struct Impl;  ///< the library's own
    /// Errors: InvalidArgument for a null handle, or if one of context's effects does not fit this library: a
    /// technique, a frozen module or a constant is absent, or lies elsewhere in its block. UnsupportedDevice with the
    /// missing feature's name.
    static Result<Renderer> create(const DeviceContext& context);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();  ///< the GPU must have finished with everything recorded

    /// Makes the missing pipelines, each once, so that recording makes none: one for each set of terms, one to
    /// composite if there is such a set, one for shadow maps. `parallel`, if given, provides the threads:
    /// device.pipelineCache must then not be externally synchronized
    /// (VK_PIPELINE_CACHE_CREATE_EXTERNALLY_SYNCHRONIZED_BIT), and no other function of this Renderer may run.
    /// Errors: InvalidArgument where `parallel` leaves jobs out;
    /// UnsupportedDevice if the device cannot draw to a format; Vulkan. Pipelines made before the error are kept.
    Result<void> prepare(const PipelineNeeds& needs, const ParallelFor& parallel = {});

    // Errors of all functions below: InvalidArgument if an argument breaks a rule stated here, UnsupportedDevice if the
    // device cannot draw to a format, and Vulkan. The recording functions make missing pipelines on first use.

    /// Starts a frame: discards the contents of `frame`, including shadow maps recorded with it, and uploads the plan's
    /// vertices, indices and constants. Call it first in a frame.
    Result<void> upload(FrameData& frame, const Plan& plan);

    /// Records a light's shadow map: clears `map` (a depth view of `size` x `size` texels in layout
    /// DEPTH_ATTACHMENT_OPTIMAL) to 0 and draws both faces of the occluders; the nearest surface wins (reversed depth).
    /// Occluders before the light's near plane throw no shadow. shadow_cache.h finds the occluders that a map needs,
    /// and the maps to draw. The map's layout does not change; the caller records the barriers before and after.
    Result<void> recordShadowMap(VkCommandBuffer commands, FrameData& frame, const Light& light,
                                 std::span<const Occluder> occluders, VkImageView map, VkFormat format,
                                 std::uint32_t size);

    /// Records the shadow hierarchy of a map of `size` x `size` texels, a depth view in layout
    /// SHADER_READ_ONLY_OPTIMAL, which Method::Raycast reads beside the map. Layout of the image before: any; after:
    /// SHADER_READ_ONLY_OPTIMAL. Record it once for each map, until the map is drawn again. Barriers between the levels
    /// are recorded.
    Result<void> recordShadowHierarchy(VkCommandBuffer commands, FrameData& frame, VkImageView map, std::uint32_t size,
                                       const ShadowHierarchy& hierarchy);

    /// Records every group of the plan: clears the accumulation target, adds the slices, composites into
    /// targets.colour. `textures` has one entry for each light given to plan(). Layout of the accumulation
    /// image before: any (contents are discarded); after: SHADER_READ_ONLY_OPTIMAL. Barriers between the passes are
    /// recorded; the caller records those against its own work.
    Result<void> record(VkCommandBuffer commands, FrameData& frame, const Plan& plan,
                        std::span<const LightTextures> textures, const ShaftTargets& targets);

    /// The two halves of record(), for callers who time or replace one: accumulate leaves the accumulation image in
    /// SHADER_READ_ONLY_OPTIMAL, and composite expects that layout.
    Result<void> recordAccumulation(VkCommandBuffer commands, FrameData& frame, const Plan& plan, std::size_t group,
                                    std::span<const LightTextures> textures, const ShaftTargets& targets);
    Result<void> recordComposite(VkCommandBuffer commands, FrameData& frame, const Plan& plan, std::size_t group,
                                 const ShaftTargets& targets);

    const RendererCounters& counters() const;

private:
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace tyndall

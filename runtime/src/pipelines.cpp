#include "pipelines.h"

#include <atomic>
#include <deque>
#include <optional>

#include "create_pipeline.h"

namespace tyndall {
namespace {

const VertexElement* elementOf(const permgen::Attribute& attribute, std::span<const VertexElement> elements) {
    for (const VertexElement& element : elements)
        if (element.semantic == attribute.semantic) return &element;
    return nullptr;
}

Result<std::vector<VkVertexInputAttributeDescription>> vertexAttributes(const Gpu& gpu, const permgen::Module& module,
                                                                        std::span<const VertexElement> elements) {
    std::vector<VkVertexInputAttributeDescription> attributes;
    for (const permgen::Attribute& attribute : module.attributes) {
        const VertexElement* element = elementOf(attribute, elements);
        if (!element)
            return invalidArgument("the vertex shader " + std::string(module.name) + " reads " +
                                   std::string(attribute.semantic) + ", which the vertices do not have");
        VkFormatProperties properties;
        vkGetPhysicalDeviceFormatProperties(gpu.physicalDevice, element->format, &properties);
        if (!(properties.bufferFeatures & VK_FORMAT_FEATURE_VERTEX_BUFFER_BIT))
            return unsupported("the device cannot read vertices of " + formatName(element->format) +
                               "; use another format for " + std::string(attribute.semantic));
        attributes.push_back({attribute.location, 0, element->format, element->offset});
    }
    return attributes;
}

/// Whether vertexAttributes() would return `attributes`.
bool madeOf(std::span<const VkVertexInputAttributeDescription> attributes, const permgen::Module& module,
            std::span<const VertexElement> elements) {
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        const VertexElement* element = elementOf(module.attributes[i], elements);
        if (!element || element->format != attributes[i].format || element->offset != attributes[i].offset)
            return false;
    }
    return true;
}

/// The pass's name in messages: its technique, and its index if there are several. Empty if the effect does not have
/// it.
std::string passName(const permgen::Effect& effect, const permgen::Pass& pass) {
    for (const permgen::Technique& technique : effect.techniques)
        for (std::size_t i = 0; i < technique.passes.size(); ++i)
            if (&technique.passes[i] == &pass)
                return std::string(technique.name) +
                       (technique.passes.size() > 1 ? ", pass " + std::to_string(i) : std::string());
    return {};
}

tl::unexpected<Error> foreignPass(const permgen::Effect& effect) {
    return invalidArgument("the pass is none of the effect " + std::string(effect.name) +
                           "; give a pass of that effect");
}

tl::unexpected<Error> within(const std::string& name, Error error) {
    error.message = name + ": " + error.message;
    return tl::unexpected(std::move(error));
}

/// The parts of a pipeline, including those that it shares with others.
struct Draft {
    const PassLayout* layout = nullptr;
    Shaders shaders = Shaders::Frozen;
    PassTarget target;
    std::vector<VkVertexInputAttributeDescription> attributes;
    std::string name;
};

const PassPipeline* find(const PipelineStore& store, const PipelineRequest& request) {
    const auto known = store.pipelines.find({request.pass, request.target});
    if (known == store.pipelines.end()) return nullptr;
    for (const PipelineStore::Entry& entry : known->second)
        if (madeOf(entry.attributes, *request.pass->vertex.module, request.elements)) return &entry.pipeline;
    return nullptr;
}

/// Makes the pass's layout if the store lacks it.
Result<const PassLayout*> layoutFor(const Gpu& gpu, PipelineStore& store, const permgen::Effect& effect,
                                    const permgen::Pass& pass, Shaders shaders, const std::string& name) {
    auto layout = store.layouts.find(&pass);
    if (layout == store.layouts.end()) {
        auto made = createLayout(gpu, pass, boundResources(effect, pass, shaders), name);
        if (!made) return tl::unexpected(made.error());
        layout = store.layouts.emplace(&pass, std::move(*made)).first;
    }
    return &layout->second;
}

Result<Draft> draft(const Gpu& gpu, PipelineStore& store, const PipelineRequest& request) {
    const permgen::Pass& pass = *request.pass;
    const std::string name = passName(*request.effect, pass);
    if (name.empty()) return foreignPass(*request.effect);
    if (pass.compute.module)
        return invalidArgument(name + ": the pass computes; ask for its pipeline without target and vertices");
    if (!pass.vertex.module) return invalidArgument(name + ": the pass has no vertex shader; give it one");
    auto attributes = vertexAttributes(gpu, *pass.vertex.module, request.elements);
    if (!attributes) return within(name, attributes.error());
    const auto layout = layoutFor(gpu, store, *request.effect, pass, request.shaders, name);
    if (!layout) return tl::unexpected(layout.error());
    return Draft{*layout, request.shaders, request.target, std::move(*attributes), name};
}

/// Thread-safe, like createPipeline().
Result<VkPipeline> make(const Gpu& gpu, const Draft& draft) {
    const auto handle = createPipeline(gpu, *draft.layout, draft.shaders, draft.target, draft.attributes);
    if (!handle) return within(draft.name, handle.error());
    setName(gpu, VK_OBJECT_TYPE_PIPELINE, *handle, draft.name);
    return handle;
}

PassPipeline keep(PipelineStore& store, Draft&& draft, VkPipeline handle) {
    auto& entries = store.pipelines[{draft.layout->pass, draft.target}];
    return entries.emplace_back(PipelineStore::Entry{std::move(draft.attributes), {handle, draft.layout}}).pipeline;
}

/// The pipelines that several threads make, each in its own slot. Destroys those that were not taken, for instance
/// after an exception.
struct Made {
    struct Slot {
        std::atomic_flag claimed;  ///< by the first call of the job; the loop may wrongly make two
        std::optional<Result<VkPipeline>> result;
    };
    const Gpu& gpu;
    std::deque<Slot> slots;  // an atomic flag cannot be moved

    Made(const Gpu& device, std::size_t count) : gpu(device), slots(count) {}
    Made(const Made&) = delete;
    Made& operator=(const Made&) = delete;
    ~Made() {
        for (const Slot& slot : slots)
            if (slot.result && *slot.result) vkDestroyPipeline(gpu.device, **slot.result, nullptr);
    }
};

bool drafted(std::span<const Draft> drafts, const PipelineRequest& request) {
    for (const Draft& other : drafts)
        if (other.layout->pass == request.pass && other.target == request.target &&
            madeOf(other.attributes, *request.pass->vertex.module, request.elements))
            return true;
    return false;
}

}  // namespace

Result<PassPipeline> pipelineFor(const Gpu& gpu, PipelineStore& store, const PipelineRequest& request,
                                 std::uint64_t& created) {
    if (const PassPipeline* known = find(store, request)) return *known;
    auto ready = draft(gpu, store, request);
    if (!ready) return tl::unexpected(ready.error());
    const auto handle = make(gpu, *ready);
    if (!handle) return tl::unexpected(handle.error());
    ++created;
    return keep(store, std::move(*ready), *handle);
}

Result<PassPipeline> computePipelineFor(const Gpu& gpu, PipelineStore& store, const permgen::Effect& effect,
                                        const permgen::Pass& pass, Shaders shaders, std::uint64_t& created) {
    if (const auto known = store.computing.find(&pass); known != store.computing.end()) return known->second;
    const std::string name = passName(effect, pass);
    if (name.empty()) return foreignPass(effect);
    if (!pass.compute.module)
        return invalidArgument(name + ": the pass draws; ask for its pipeline with a target and vertices");
    const auto layout = layoutFor(gpu, store, effect, pass, shaders, name);
    if (!layout) return tl::unexpected(layout.error());
    const auto handle = createComputePipeline(gpu, **layout, shaders);
    if (!handle) return within(name, handle.error());
    setName(gpu, VK_OBJECT_TYPE_PIPELINE, *handle, name);
    ++created;
    return store.computing.emplace(&pass, PassPipeline{*handle, *layout}).first->second;
}

Result<void> makePipelines(const Gpu& gpu, PipelineStore& store, std::span<const PipelineRequest> requests,
                           const ParallelFor& parallel, std::uint64_t& created) {
    std::vector<Draft> drafts;
    Result<void> outcome;
    for (const PipelineRequest& request : requests) {
        if (find(store, request) || drafted(drafts, request)) continue;
        auto ready = draft(gpu, store, request);
        if (ready)
            drafts.push_back(std::move(*ready));
        else if (outcome)
            outcome = tl::unexpected(ready.error());
    }

    Made made(gpu, drafts.size());
    const std::function<void(std::size_t)> job = [&](std::size_t i) {
        if (i < drafts.size() && !made.slots[i].claimed.test_and_set()) made.slots[i].result = make(gpu, drafts[i]);
    };
    if (drafts.empty()) return outcome;
    if (parallel)
        parallel(drafts.size(), job);
    else
        for (std::size_t i = 0; i < drafts.size(); ++i) job(i);

    for (std::size_t i = 0; i < drafts.size(); ++i) {
        std::optional<Result<VkPipeline>>& result = made.slots[i].result;
        if (!result) {
            if (outcome)
                outcome = invalidArgument("the parallel loop left out pipeline " + std::to_string(i) + " of " +
                                          std::to_string(drafts.size()) + "; it must call every job once");
        } else if (!*result) {
            if (outcome) outcome = tl::unexpected(result->error());
        } else {
            keep(store, std::move(drafts[i]), **result);
            result.reset();
            ++created;
        }
    }
    return outcome;
}

void destroyPipelines(const Gpu& gpu, PipelineStore& store) {
    for (auto& [key, entries] : store.pipelines)
        for (const PipelineStore::Entry& entry : entries) vkDestroyPipeline(gpu.device, entry.pipeline.handle, nullptr);
    for (const auto& [pass, pipeline] : store.computing) vkDestroyPipeline(gpu.device, pipeline.handle, nullptr);
    for (auto& [pass, layout] : store.layouts) destroyLayout(gpu, layout);
    store = {};
}

}  // namespace tyndall

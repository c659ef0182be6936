#include "check_document.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "check_transform.h"

namespace tyndall::app {
namespace {

using nlohmann::json;

/// Doubles are exact integers up to here; no count in a file that this program reads is that large.
constexpr std::uint64_t largestCount = std::uint64_t{1} << 53;

struct Broken {
    std::string sentence;
};

template <class... Args>
[[noreturn]] void broken(fmt::format_string<Args...> text, Args&&... args) {
    throw Broken{fmt::format(text, std::forward<Args>(args)...)};
}

const json& list(const json& parent, const char* key) {
    static const json none = json::array();
    const auto found = parent.find(key);
    if (found == parent.end()) return none;
    if (!found->is_array()) broken("\"{}\" must be an array; export the file again", key);
    return *found;
}

const json& objects(const json& gltf, const char* key) {
    const json& all = list(gltf, key);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!all[i].is_object()) broken("{}[{}] must be an object; export the file again", key, i);
    return all;
}

std::optional<std::uint64_t> natural(const json& value) {
    if (!value.is_number_unsigned()) return std::nullopt;
    const auto number = value.get<std::uint64_t>();
    return number < largestCount ? std::optional(number) : std::nullopt;
}

std::uint64_t count(const json& object, const char* key, std::uint64_t fallback, const std::string& place) {
    const auto found = object.find(key);
    if (found == object.end()) return fallback;
    const auto number = natural(*found);
    if (!number)
        broken("{}.{} is {}, but must be a whole number from 0; export the file again", place, key, found->dump());
    return *number;
}

void index(const json& value, std::size_t size, const std::string& place, const char* what) {
    const auto number = natural(value);
    if (!number || *number >= size)
        broken("{} is {}, but the file has {} {}; export it again", place, value.dump(), size, what);
}

void optionalIndex(const json& object, const char* key, std::size_t size, const std::string& place, const char* what) {
    if (const auto found = object.find(key); found != object.end())
        index(*found, size, fmt::format("{}.{}", place, key), what);
}

const json* member(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_object() ? &*found : nullptr;
}

void checkExtensions(const json& gltf) {
    static constexpr std::array known = {"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                         "KHR_mesh_quantization"};
    for (const json& name : list(gltf, "extensionsRequired")) {
        if (!name.is_string()) broken("extensionsRequired must hold names; export the file again");
        const bool cosmetic = name.get_ref<const std::string&>().starts_with("KHR_materials_");
        if (!cosmetic && std::ranges::find(known, name.get_ref<const std::string&>()) == known.end())
            broken("requires the extension {}, which is not read; export without it", name.get<std::string>());
    }
}

void checkBuffers(const json& gltf, bool binary, std::size_t binaryLength) {
    const json& buffers = objects(gltf, "buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::string place = fmt::format("buffers[{}]", i);
        const std::uint64_t length = count(buffers[i], "byteLength", 0, place);
        if (length == 0) broken("{}.byteLength must be at least 1; export the file again", place);
        if (buffers[i].contains("uri")) continue;
        if (!binary) broken("{} has no uri; export the file again", place);
        if (length > binaryLength)
            broken("{} is {} bytes long, but the file's binary chunk has {}; export it again", place, length,
                   binaryLength);
    }
    const json& views = objects(gltf, "bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i) {
        const std::string place = fmt::format("bufferViews[{}]", i);
        if (!views[i].contains("buffer")) broken("{} names no buffer; export the file again", place);
        optionalIndex(views[i], "buffer", buffers.size(), place, "buffers");
        const std::uint64_t size = count(buffers[views[i]["buffer"].get<std::size_t>()], "byteLength", 0, place);
        const std::uint64_t offset = count(views[i], "byteOffset", 0, place);
        const std::uint64_t length = count(views[i], "byteLength", 0, place);
        if (length == 0 || offset > size || length > size - offset)
            broken("{} spans bytes {} to {} of a buffer of {}; export the file again", place, offset, offset + length,
                   size);
        const std::uint64_t stride = count(views[i], "byteStride", 4, place);
        if (stride < 4 || stride > 252)
            broken("{}.byteStride is {}, but must be from 4 to 252; export the file again", place, stride);
    }
}

std::uint64_t componentBytes(std::uint64_t type) {
    switch (type) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return 0;
    }
}

std::uint64_t componentCount(const std::string& type) {
    static constexpr std::array<std::pair<const char*, std::uint64_t>, 7> types = {
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    for (const auto& [name, number] : types)
        if (type == name) return number;
    return 0;
}

void checkAccessors(const json& gltf) {
    const json& views = objects(gltf, "bufferViews");
    const json& accessors = objects(gltf, "accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i) {
        const json& accessor = accessors[i];
        const std::string place = fmt::format("accessors[{}]", i);
        if (accessor.contains("sparse"))
            broken("{} is sparse, but sparse accessors are not read; export without them", place);
        const std::uint64_t component = componentBytes(count(accessor, "componentType", 0, place));
        const auto type = accessor.find("type");
        const std::uint64_t components =
            type != accessor.end() && type->is_string() ? componentCount(type->get<std::string>()) : 0;
        if (component == 0 || components == 0)
            broken("{} has an unknown type or componentType; export the file again", place);
        const std::uint64_t elements = count(accessor, "count", 0, place);
        if (elements == 0) broken("{}.count must be at least 1; export the file again", place);
        const std::uint64_t offset = count(accessor, "byteOffset", 0, place);
        if (!accessor.contains("bufferView")) broken("{} has no buffer view; export the file again", place);
        optionalIndex(accessor, "bufferView", views.size(), place, "buffer views");
        const json& view = views[accessor["bufferView"].get<std::size_t>()];
        const std::uint64_t length = count(view, "byteLength", 0, place);
        const std::uint64_t element = component * components;
        const std::uint64_t stride = count(view, "byteStride", element, place);
        if (stride < element || stride % component != 0)
            broken("{} has elements of {} bytes, {} bytes apart; export the file again", place, element, stride);
        if (offset > length || element > length - offset || elements - 1 > (length - offset - element) / stride)
            broken("{} has {} elements of {} bytes, more than its buffer view of {} holds; export the file again",
                   place, elements, element, length);
    }
}

void checkMaterials(const json& gltf) {
    const std::size_t textures = objects(gltf, "textures").size();
    const json& images = objects(gltf, "images");
    for (std::size_t i = 0; i < images.size(); ++i)
        optionalIndex(images[i], "bufferView", objects(gltf, "bufferViews").size(), fmt::format("images[{}]", i),
                      "buffer views");
    for (std::size_t i = 0; i < textures; ++i) {
        const std::string place = fmt::format("textures[{}]", i);
        optionalIndex(gltf["textures"][i], "source", images.size(), place, "images");
        optionalIndex(gltf["textures"][i], "sampler", objects(gltf, "samplers").size(), place, "samplers");
    }
    const json& materials = objects(gltf, "materials");
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const std::string place = fmt::format("materials[{}]", i);
        const json* pbr = member(materials[i], "pbrMetallicRoughness");
        const std::array<std::pair<const json*, const char*>, 5> infos = {{{pbr, "baseColorTexture"},
                                                                           {pbr, "metallicRoughnessTexture"},
                                                                           {&materials[i], "normalTexture"},
                                                                           {&materials[i], "occlusionTexture"},
                                                                           {&materials[i], "emissiveTexture"}}};
        for (const auto& [owner, name] : infos)
            if (const json* info = owner != nullptr ? member(*owner, name) : nullptr)
                optionalIndex(*info, "index", textures, fmt::format("{}.{}", place, name), "textures");
    }
}

void checkMeshes(const json& gltf) {
    const std::size_t accessors = objects(gltf, "accessors").size();
    const json& meshes = objects(gltf, "meshes");
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const json& primitives = objects(meshes[i], "primitives");
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const std::string place = fmt::format("meshes[{}].primitives[{}]", i, p);
            if (const std::uint64_t mode = count(primitives[p], "mode", 4, place); mode > 6)
                broken("{}.mode is {}, but must be from 0 to 6; export the file again", place, mode);
            optionalIndex(primitives[p], "indices", accessors, place, "accessors");
            optionalIndex(primitives[p], "material", objects(gltf, "materials").size(), place, "materials");
            if (const json* attributes = member(primitives[p], "attributes"))
                for (const auto& [name, value] : attributes->items())
                    index(value, accessors, fmt::format("{}.attributes.{}", place, name), "accessors");
        }
    }
}

void checkAnimations(const json& gltf) {
    const json& animations = objects(gltf, "animations");
    for (std::size_t i = 0; i < animations.size(); ++i) {
        const json& samplers = objects(animations[i], "samplers");
        for (std::size_t s = 0; s < samplers.size(); ++s) {
            const std::string place = fmt::format("animations[{}].samplers[{}]", i, s);
            for (const char* key : {"input", "output"}) {
                if (!samplers[s].contains(key)) broken("{} has no {}; export the file again", place, key);
                optionalIndex(samplers[s], key, objects(gltf, "accessors").size(), place, "accessors");
            }
        }
        const json& channels = objects(animations[i], "channels");
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const std::string place = fmt::format("animations[{}].channels[{}]", i, c);
            if (!channels[c].contains("sampler")) broken("{} has no sampler; export the file again", place);
            optionalIndex(channels[c], "sampler", samplers.size(), place, "samplers in that animation");
            if (const json* target = member(channels[c], "target"))
                optionalIndex(*target, "node", objects(gltf, "nodes").size(), place + ".target", "nodes");
        }
    }
}

std::size_t lightCount(const json& gltf) {
    const json* extensions = member(gltf, "extensions");
    const json* lights = extensions != nullptr ? member(*extensions, "KHR_lights_punctual") : nullptr;
    return lights != nullptr ? objects(*lights, "lights").size() : 0;
}

/// glTF 2.0, section 3.5.2: nodes form disjoint strict trees.
void checkTree(const json& nodes) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> parent(nodes.size(), none);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const json& child : list(nodes[i], "children")) {
            index(child, nodes.size(), fmt::format("nodes[{}].children", i), "nodes");
            std::size_t& above = parent[child.get<std::size_t>()];
            if (above != none)
                broken(
                    "nodes[{}] is a child of nodes[{}] and of nodes[{}], but may have only one parent; "
                    "export the file again",
                    child.get<std::size_t>(), above, i);
            above = i;
        }
    // As each node has one parent, a node that is not below a root is in a cycle.
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (parent[i] == none) open.push_back(i);
    std::size_t reached = 0;
    std::vector<bool> seen(nodes.size(), false);
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        seen[node] = true;
        ++reached;
        for (const json& child : list(nodes[node], "children")) open.push_back(child.get<std::size_t>());
    }
    if (reached == nodes.size()) return;
    const auto first = static_cast<std::size_t>(std::ranges::find(seen, false) - seen.begin());
    broken("nodes[{}] is its own ancestor; remove the cycle from the node hierarchy", first);
}

void checkNodes(const json& gltf) {
    const json& nodes = objects(gltf, "nodes");
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::string place = fmt::format("nodes[{}]", i);
        optionalIndex(nodes[i], "mesh", objects(gltf, "meshes").size(), place, "meshes");
        optionalIndex(nodes[i], "camera", objects(gltf, "cameras").size(), place, "cameras");
        if (auto checked = checkTransform(nodes[i], place); !checked) throw Broken{checked.error().message};
        const json* extensions = member(nodes[i], "extensions");
        const json* light = extensions != nullptr ? member(*extensions, "KHR_lights_punctual") : nullptr;
        if (light != nullptr) optionalIndex(*light, "light", lightCount(gltf), place, "lights");
    }
    const json& scenes = objects(gltf, "scenes");
    for (std::size_t i = 0; i < scenes.size(); ++i)
        for (const json& node : list(scenes[i], "nodes"))
            index(node, nodes.size(), fmt::format("scenes[{}].nodes", i), "nodes");
    if (gltf.contains("scene")) index(gltf["scene"], scenes.size(), "scene", "scenes");
    checkTree(nodes);
}

}  // namespace

Result<void> checkDocument(const json& gltf, bool binary, std::size_t binaryLength) {
    try {
        if (!gltf.is_object()) broken("its JSON is not an object; name a glTF file");
        checkExtensions(gltf);
        checkBuffers(gltf, binary, binaryLength);
        checkAccessors(gltf);
        checkMaterials(gltf);
        checkMeshes(gltf);
        checkAnimations(gltf);
        checkNodes(gltf);
    } catch (const Broken& wrong) {
        return failWith(wrong.sentence);
    }
    return {};
}

}  // namespace tyndall::app

#include <permgen/manifest.h>

#include <algorithm>
#include <map>

#include "d3d9/image_formats.h"
#include "d3d9/states.h"
#include "fault.h"
#include "json_node.h"
#include "spirv_file.h"
#include "storage.h"

namespace permgen {
namespace {

constexpr std::uint32_t known_format = 2;
constexpr std::string_view manifest_ending = ".fx.json";

constexpr NamedValue<ScalarType> scalars[] = {
    {"bool", ScalarType::Bool}, {"int", ScalarType::Int}, {"uint", ScalarType::Uint}, {"float", ScalarType::Float}};
constexpr NamedValue<Stage> stages[] = {
    {"vertex", Stage::Vertex}, {"pixel", Stage::Pixel}, {"compute", Stage::Compute}};
constexpr NamedValue<ResourceKind> kinds[] = {{"uniform-buffer", ResourceKind::UniformBuffer},
                                              {"combined-image-sampler", ResourceKind::CombinedImageSampler},
                                              {"storage-image", ResourceKind::StorageImage},
                                              {"storage-buffer", ResourceKind::StorageBuffer}};
constexpr auto formats = [] {
    std::array<NamedValue<ImageFormat>, std::size(d3d9::image_formats)> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = {d3d9::image_formats[i].name, d3d9::image_formats[i].format};
    return values;
}();
constexpr NamedValue<ValueKind> value_kinds[] = {
    {"bool", ValueKind::Bool},       {"enum", ValueKind::Enum},
    {"integer", ValueKind::Integer}, {"float", ValueKind::Float},
    {"flags", ValueKind::Flags},     {"colour", ValueKind::Colour},
    {"object", ValueKind::Object},   {"expression", ValueKind::Expression}};
constexpr NamedValue<ImageDimension> dimensions[] = {{"1d", ImageDimension::One},
                                                     {"2d", ImageDimension::Two},
                                                     {"3d", ImageDimension::Three},
                                                     {"cube", ImageDimension::Cube}};

/// Fills a Storage from the manifest, leaves first, because tables point to one another.
class Loader {
public:
    Loader(std::filesystem::path folder, LoadedEffect::Storage& storage)
        : folder_(std::move(folder)), storage_(storage) {}
    void load(const JsonNode& manifest);

private:
    std::string_view text(const JsonNode& node) { return storage_.keep(node.text()); }
    std::span<const std::uint32_t> code(const JsonNode& file);
    std::span<const State> states(const JsonNode& list);
    State state(const JsonNode& node);
    Constant constant(const JsonNode& node);
    Module module(const JsonNode& node);
    std::array<std::uint32_t, 3> group_size(const JsonNode& node, Stage stage);
    Resource resource(const JsonNode& node);
    Member member(const JsonNode& node);
    Shader shader(const JsonNode& node, Stage stage);
    Pass pass(const JsonNode& node);
    Technique technique(const JsonNode& node);

    /// One table entry for each item of a list.
    template <class T>
    std::span<T> table(const JsonNode& list, T (Loader::*entry)(const JsonNode&)) {
        std::vector<T> entries;
        for (const JsonNode& item : list.items()) entries.push_back((this->*entry)(item));
        return storage_.keep(std::move(entries));
    }

    std::filesystem::path folder_;
    LoadedEffect::Storage& storage_;
    std::map<std::string, std::span<const std::uint32_t>> codes_;  ///< by file, of those already read
    std::span<const Module> modules_;
};

template <class T>
void check_names(const JsonNode& list, std::span<const T> entries) {
    const std::vector<JsonNode> nodes = list.items();
    for (std::size_t i = 0; i < entries.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (entries[i].name == entries[j].name)
                nodes[i].fail("the name '" + std::string(entries[i].name) + "' occurs twice");
}

std::span<const std::uint32_t> Loader::code(const JsonNode& node) {
    const std::string file = node.text();
    if (file.empty() || file.find_first_of("/\\") != std::string::npos || file == "." || file == "..")
        node.fail("'" + file + "' does not name a file beside the manifest");
    const auto [entry, added] = codes_.try_emplace(file);
    if (added) entry->second = storage_.keep(read_spirv(folder_ / file));
    return entry->second;
}

std::span<const State> Loader::states(const JsonNode& list) {
    return table(list, &Loader::state);
}

State Loader::state(const JsonNode& node) {
    const d3d9::StateRow* row = d3d9::find_state(node["state"].text());
    if (!row) node["state"].fail("'" + node["state"].text() + "' is not a state of Direct3D 9");
    const State state{
        text(node["name"]),   text(node["value"]), row->id, node["index"].number(), node["kind"].word(value_kinds),
        node["bits"].number()};
    if (state.kind != row->kind && state.kind != ValueKind::Expression)
        node["kind"].fail("'" + std::string(row->name) + "' has no value of the kind '" + node["kind"].text() + "'");
    const bool named = state.kind == ValueKind::Enum || state.kind == ValueKind::Bool;
    if (named && !d3d9::find_value(*row, state.bits))
        node["bits"].fail("'" + std::string(row->name) + "' has no value " + std::to_string(state.bits));
    return state;
}

Constant Loader::constant(const JsonNode& node) {
    return {text(node["name"]), node["id"].number(), node["type"].word(scalars), node["bits"].number()};
}

Module Loader::module(const JsonNode& node) {
    std::vector<Attribute> attributes;
    for (const JsonNode& attribute : node["attributes"].items()) {
        const std::uint32_t components = attribute["components"].number();
        if (components < 1 || components > 4) attribute["components"].fail("an attribute has 1 to 4 components");
        attributes.push_back(
            {text(attribute["semantic"]), attribute["location"].number(), components, attribute["type"].word(scalars)});
    }
    std::vector<Constant> axes;
    for (const JsonNode& axis : node["axes"].items()) axes.push_back(constant(axis));
    return {text(node["name"]),
            text(node["entry"]),
            node["stage"].word(stages),
            code(node["file"]),
            storage_.keep(std::move(axes)),
            storage_.keep(std::move(attributes)),
            group_size(node, node["stage"].word(stages))};
}

std::array<std::uint32_t, 3> Loader::group_size(const JsonNode& node, Stage stage) {
    std::array<std::uint32_t, 3> size{};
    if (stage != Stage::Compute) {
        if (node.has("group_size")) node["group_size"].fail("only a compute module has a thread group");
        return size;
    }
    constexpr std::uint64_t most_threads = 1024;  // of a group, in any profile
    const std::vector<JsonNode> items = node["group_size"].items();
    if (items.size() != size.size())
        node["group_size"].fail("a thread group has three sizes, and these are " + std::to_string(items.size()));
    std::uint64_t threads = 1;
    for (std::size_t axis = 0; axis < size.size(); ++axis) {
        size[axis] = items[axis].number();
        if (size[axis] < 1 || size[axis] > most_threads) items[axis].fail("a size of a thread group is 1 to 1024");
        threads *= size[axis];
    }
    if (threads > most_threads) node["group_size"].fail("a thread group has 1024 threads at most");
    return size;
}

Resource Loader::resource(const JsonNode& node) {
    Resource resource{text(node["name"]),
                      node["kind"].word(kinds),
                      ImageDimension::None,
                      node["set"].number(),
                      node["binding"].number(),
                      0,
                      {}};
    const bool is_storage = resource.kind == ResourceKind::StorageImage || resource.kind == ResourceKind::StorageBuffer;
    if (resource.kind == ResourceKind::UniformBuffer || resource.kind == ResourceKind::StorageBuffer)
        resource.size = node["size"].number();
    else
        resource.dimension = node["dimension"].word(dimensions);
    if (resource.kind == ResourceKind::CombinedImageSampler) resource.sampler_states = states(node["sampler_states"]);
    if (resource.kind == ResourceKind::StorageImage) resource.format = node["format"].word(formats);
    if (is_storage) resource.writable = node["writable"].truth();
    return resource;
}

Member Loader::member(const JsonNode& node) {
    const Member member{text(node["block"]), text(node["name"]), node["offset"].number(), node["size"].number()};
    const Resource* block = find_resource(storage_.effect, member.block);
    if (!block || (block->kind != ResourceKind::UniformBuffer && block->kind != ResourceKind::StorageBuffer))
        node["block"].fail("there is no uniform block or storage buffer '" + std::string(member.block) + "'");
    if (std::uint64_t{member.offset} + member.size > block->size)
        node.fail("the member ends beyond its block's " + std::to_string(block->size) + " bytes");
    return member;
}

Shader Loader::shader(const JsonNode& node, Stage stage) {
    if (node.is_null()) return {};
    const std::string name = node["module"].text();
    const auto found = std::find_if(modules_.begin(), modules_.end(), [&](const Module& m) { return m.name == name; });
    if (found == modules_.end()) node["module"].fail("there is no module '" + name + "'");
    if (found->stage != stage) node["module"].fail("the module '" + name + "' is of another stage");
    Shader shader{&*found, table(node["constants"], &Loader::constant), {}};
    const auto same = [](const Constant& a, const Constant& b) {
        return a.name == b.name && a.id == b.id && a.type == b.type;
    };
    if (!std::equal(shader.constants.begin(), shader.constants.end(), found->axes.begin(), found->axes.end(), same))
        node["constants"].fail("these are not the axes of the module '" + name + "'");
    if (node.has("frozen")) shader.frozen = code(node["frozen"]);
    return shader;
}

Pass Loader::pass(const JsonNode& node) {
    std::vector<const Resource*> live;
    for (const JsonNode& item : node["live"].items()) {
        live.push_back(find_resource(storage_.effect, item.text()));
        if (!live.back()) item.fail("there is no resource '" + item.text() + "'");
    }
    Pass pass{text(node["name"]),
              shader(node["vertex"], Stage::Vertex),
              shader(node["pixel"], Stage::Pixel),
              storage_.keep(std::move(live)),
              states(node["states"]),
              {}};
    if (node.has("compute")) pass.compute = shader(node["compute"], Stage::Compute);  // absent before there were any
    if (pass.compute.module && (pass.vertex.module || pass.pixel.module))
        node["compute"].fail("a pass either computes or draws");
    return pass;
}

Technique Loader::technique(const JsonNode& node) {
    return {text(node["name"]), table(node["passes"], &Loader::pass)};
}

void Loader::load(const JsonNode& manifest) {
    if (const std::uint32_t format = manifest["format"].number(); format != known_format)
        manifest["format"].fail("this is format " + std::to_string(format) + ", and only " +
                                std::to_string(known_format) + " is known here");
    Effect& effect = storage_.effect;
    effect.name = text(manifest["effect"]);
    modules_ = table(manifest["modules"], &Loader::module);
    check_names(manifest["modules"], modules_);
    std::vector<const Module*> pointers;
    for (const Module& module : modules_) pointers.push_back(&module);
    effect.modules = storage_.keep(std::move(pointers));
    effect.resources = table(manifest["resources"], &Loader::resource);
    check_names(manifest["resources"], effect.resources);
    effect.members = table(manifest["members"], &Loader::member);
    effect.techniques = table(manifest["techniques"], &Loader::technique);
}

/// The manifest, or the only one in a folder.
std::filesystem::path find_manifest(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_directory(path, error)) return path;
    std::vector<std::filesystem::path> found;
    for (std::filesystem::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().filename().string().ends_with(manifest_ending)) found.push_back(entry->path());
    if (error) throw Fault{path.string() + ": the folder cannot be read (" + error.message() + ")", ErrorCode::File};
    if (found.size() == 1) return found.front();
    const std::string remedy = found.empty() ? "; run permgen compile with it as the folder" : "; name one of them";
    throw Fault{path.string() + ": the folder holds " + std::to_string(found.size()) + " manifests (*" +
                    std::string(manifest_ending) + ")" + remedy,
                ErrorCode::File};
}

nlohmann::json parse(const std::filesystem::path& file) {
    try {
        return nlohmann::json::parse(read_bytes(file));
    } catch (const nlohmann::json::exception& error) {
        const std::string what = error.what();  // "[json.exception.parse_error.101] parse error at line 1, ..."
        const std::size_t bracket = what.find("] ");
        throw Fault{file.string() + ": " + (bracket == std::string::npos ? what : what.substr(bracket + 2)) +
                    "; write it again with permgen compile"};
    }
}

}  // namespace

LoadedEffect::LoadedEffect(std::unique_ptr<const Storage> storage) : storage_(std::move(storage)) {}
LoadedEffect::LoadedEffect(LoadedEffect&&) noexcept = default;
LoadedEffect& LoadedEffect::operator=(LoadedEffect&&) noexcept = default;
LoadedEffect::~LoadedEffect() = default;

const Effect& LoadedEffect::tables() const {
    return storage_->effect;
}

Result<LoadedEffect> load_manifest(const std::filesystem::path& manifest) {
    try {
        const std::filesystem::path file = find_manifest(manifest);
        const nlohmann::json json = parse(file);
        auto storage = std::make_unique<LoadedEffect::Storage>();
        Loader(file.parent_path(), *storage).load(JsonNode(json, file.string()));
        return LoadedEffect(std::move(storage));
    } catch (const Fault& fault) {
        return tl::unexpected(Error{fault.code, fault.message, 0, manifest.string()});
    }
}

}  // namespace permgen

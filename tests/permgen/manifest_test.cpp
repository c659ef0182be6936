// The tables loaded from a folder equal those of the generated header; a damaged folder is refused with a sentence that
// names file and place.
#include <compute.fx.h>
#include <everything.fx.h>
#include <gtest/gtest.h>
#include <permgen/manifest.h>
#include <slices.fx.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

namespace permgen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

template <class T, class Compare>
void expect_same(std::span<T> a, std::span<T> b, Compare compare) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        SCOPED_TRACE(i);
        compare(a[i], b[i]);
    }
}

void same_word(std::uint32_t a, std::uint32_t b) {
    EXPECT_EQ(a, b);
}

void same_constant(const Constant& a, const Constant& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.type, b.type);
    EXPECT_EQ(a.bits, b.bits);
}

void same_state(const State& a, const State& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.value, b.value);
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.index, b.index);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.bits, b.bits);
}

void same_attribute(const Attribute& a, const Attribute& b) {
    EXPECT_EQ(a.semantic, b.semantic);
    EXPECT_EQ(a.location, b.location);
    EXPECT_EQ(a.components, b.components);
    EXPECT_EQ(a.type, b.type);
}

void same_module(const Module& a, const Module& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.entry, b.entry);
    EXPECT_EQ(a.stage, b.stage);
    expect_same(a.code, b.code, same_word);
    expect_same(a.axes, b.axes, same_constant);
    expect_same(a.attributes, b.attributes, same_attribute);
    EXPECT_EQ(a.group_size, b.group_size);
}

void same_resource(const Resource& a, const Resource& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.dimension, b.dimension);
    EXPECT_EQ(a.set, b.set);
    EXPECT_EQ(a.binding, b.binding);
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(a.format, b.format);
    EXPECT_EQ(a.writable, b.writable);
    expect_same(a.sampler_states, b.sampler_states, same_state);
}

void same_member(const Member& a, const Member& b) {
    EXPECT_EQ(a.block, b.block);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_EQ(a.size, b.size);
}

/// Corresponding passes of two tables; each refers to its own table.
template <class Range, class T>
std::ptrdiff_t place_in(const Range& table, const T* entry) {
    return std::find(table.begin(), table.end(), entry) - table.begin();
}

struct SamePass {
    const Effect &a, &b;

    void shader(const Shader& left, const Shader& right) const {
        ASSERT_EQ(left.module == nullptr, right.module == nullptr);
        if (left.module) {
            EXPECT_EQ(place_in(a.modules, left.module), place_in(b.modules, right.module));
            EXPECT_LT(place_in(a.modules, left.module), std::ssize(a.modules));
        }
        expect_same(left.constants, right.constants, same_constant);
        expect_same(left.frozen, right.frozen, same_word);
    }
    void operator()(const Pass& left, const Pass& right) const {
        EXPECT_EQ(left.name, right.name);
        shader(left.vertex, right.vertex);
        shader(left.pixel, right.pixel);
        shader(left.compute, right.compute);
        expect_same(left.live, right.live, [&](const Resource* l, const Resource* r) {
            EXPECT_EQ(l - a.resources.data(), r - b.resources.data());
            EXPECT_LT(static_cast<std::size_t>(l - a.resources.data()), a.resources.size());
        });
        expect_same(left.states, right.states, same_state);
    }
};

void expect_same(const Effect& a, const Effect& b) {
    EXPECT_EQ(a.name, b.name);
    expect_same(a.modules, b.modules, [](const Module* l, const Module* r) { same_module(*l, *r); });
    expect_same(a.resources, b.resources, same_resource);
    expect_same(a.members, b.members, same_member);
    expect_same(a.techniques, b.techniques, [&](const Technique& l, const Technique& r) {
        EXPECT_EQ(l.name, r.name);
        expect_same(l.passes, r.passes, SamePass{a, b});
    });
}

TEST(LoadManifest, GivesTheGeneratedHeadersTables) {
    auto loaded = load_manifest(EFFECTS "/slices.fx.json");
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_FALSE(loaded->tables().techniques[0].passes[0].pixel.frozen.empty());
    expect_same(loaded->tables(), slices::effect);
}

TEST(LoadManifest, GivesAxesOfEveryTypeAndImagesOfEveryDimension) {
    const auto loaded = load_manifest(EFFECTS "/everything.fx.json");
    ASSERT_TRUE(loaded) << loaded.error().message;
    const Effect& effect = loaded->tables();
    ASSERT_EQ(effect.techniques.size(), 2u);
    EXPECT_EQ(effect.techniques[1].passes[0].pixel.module, nullptr);
    EXPECT_EQ(find_resource(effect, "Sky")->dimension, ImageDimension::Cube);
    EXPECT_EQ(effect.techniques[0].passes[0].pixel.constants[1].bits, static_cast<std::uint32_t>(-3));
    expect_same(effect, everything::effect);
}

// The fixture's numbers, from the header at compile time.
static_assert(compute::effect.modules[0]->group_size == std::array<std::uint32_t, 3>{8, 4, 2});
static_assert(compute::effect.modules[1]->group_size == std::array<std::uint32_t, 3>{64, 1, 1});
static_assert(compute::effect.modules[0]->stage == Stage::Compute);
static_assert(compute::effect.modules[0]->attributes.empty());
static_assert(find_resource(compute::effect, "image")->kind == ResourceKind::StorageImage);
static_assert(find_resource(compute::effect, "image")->format == ImageFormat::Rgba32f);
static_assert(find_resource(compute::effect, "small")->format == ImageFormat::Rgba16f);
static_assert(find_resource(compute::effect, "cells")->kind == ResourceKind::StorageBuffer);
static_assert(!find_resource(compute::effect, "cells")->writable);
static_assert(find_resource(compute::effect, "results")->writable);
static_assert(compute::cs_main_key_of(compute::TechniqueId::deep) == compute::cs_main_key{true, -2, 1.0F});

TEST(LoadManifest, GivesComputeShadersAndTheirResources) {
    const auto loaded = load_manifest(EFFECTS "/compute.fx.json");
    ASSERT_TRUE(loaded) << loaded.error().message;
    const Effect& effect = loaded->tables();
    EXPECT_EQ(effect.modules[0]->group_size, (std::array<std::uint32_t, 3>{8, 4, 2}));
    EXPECT_EQ(find_resource(effect, "volume")->dimension, ImageDimension::Three);
    const Pass& fill = effect.techniques[1].passes[1];
    EXPECT_EQ(fill.vertex.module, nullptr);
    EXPECT_EQ(fill.compute.module, effect.modules[0]);
    EXPECT_FALSE(fill.compute.frozen.empty());
    EXPECT_TRUE(is_live(fill, "volume"));
    EXPECT_FALSE(is_live(effect.techniques[0].passes[0], "volume"));
    expect_same(effect, compute::effect);
}

TEST(LoadManifest, PointersSurviveAMove) {
    auto loaded = load_manifest(EFFECTS "/everything.fx.json");
    ASSERT_TRUE(loaded) << loaded.error().message;
    const Effect* before = &loaded->tables();
    LoadedEffect moved = std::move(*loaded);
    EXPECT_EQ(&moved.tables(), before);
    LoadedEffect again = load_manifest(EFFECTS "/slices.fx.json").value();
    again = std::move(moved);
    EXPECT_EQ(&again.tables(), before);
    expect_same(again.tables(), everything::effect);
}

class BrokenManifest : public testing::Test {
protected:
    explicit BrokenManifest(const std::string& effect = "everything") {
        std::string pattern = testing::TempDir() + "permgen_manifest_XXXXXX";
        folder = ::mkdtemp(pattern.data());
        for (const auto& entry : fs::directory_iterator(EFFECTS))
            if (entry.path().filename().string().starts_with(effect)) fs::copy(entry.path(), folder);
        manifest = folder / (effect + ".fx.json");
        std::ifstream file(manifest);
        json = Json::parse(file);
    }
    ~BrokenManifest() override { fs::remove_all(folder); }

    void put(const fs::path& file, const std::string& bytes) const {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    }
    /// Expects an error whose message contains `file` and `what`.
    void expect_refused(const fs::path& file, const std::string& what) const {
        const auto loaded = load_manifest(manifest);
        ASSERT_FALSE(loaded) << what;
        EXPECT_EQ(loaded.error().message.rfind(file.string() + ": ", 0), 0u) << loaded.error().message;
        EXPECT_NE(loaded.error().message.find(what), std::string::npos) << loaded.error().message;
        EXPECT_EQ(loaded.error().message.find('\n'), std::string::npos) << loaded.error().message;
    }
    void expect_refused(const Json& changed, const std::string& what) const {
        put(manifest, changed.dump());
        expect_refused(manifest, what);
    }

    fs::path folder, manifest;
    Json json;
};

TEST_F(BrokenManifest, AFolderIsGoodForItsOnlyManifest) {
    auto loaded = load_manifest(folder);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->tables().name, "everything");
    fs::copy(manifest, folder / "other.fx.json");
    loaded = load_manifest(folder);
    EXPECT_NE(loaded.error().message.find(folder.string() + ": the folder holds 2 manifests"), std::string::npos)
        << loaded.error().message;
    fs::remove_all(folder);
    fs::create_directory(folder);
    loaded = load_manifest(folder);
    EXPECT_NE(loaded.error().message.find("the folder holds 0 manifests"), std::string::npos) << loaded.error().message;
}

TEST_F(BrokenManifest, FilesThatAreNotThere) {
    const fs::path code = folder / json["modules"][0]["file"].get<std::string>();
    fs::remove(code);
    expect_refused(code, "there is no such file");
    ASSERT_EQ(::mkfifo(code.c_str(), 0600), 0);
    expect_refused(code, "this is not a regular file");
    fs::remove(code);
    fs::create_directory(code);
    expect_refused(code, "this is not a regular file");
    fs::remove(manifest);
    expect_refused(manifest, "there is no such file");
}

TEST_F(BrokenManifest, FilesThatAreNoSpirv) {
    const fs::path code = folder / json["modules"][0]["file"].get<std::string>();
    std::ifstream file(code, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    put(code, "");
    expect_refused(code, "the file ends after 0 bytes, within SPIR-V's header");
    put(code, bytes.substr(0, 16));
    expect_refused(code, "the file ends after 16 bytes, within SPIR-V's header");
    put(code, bytes.substr(0, bytes.size() - 1));
    expect_refused(code, "which is not a whole number of words");
    put(code, std::string(bytes.size(), ' '));
    expect_refused(code, "does not begin with SPIR-V's magic number");
    std::string swapped = bytes;
    std::reverse(swapped.begin(), swapped.begin() + 4);
    put(code, swapped);
    expect_refused(code, "does not begin with SPIR-V's magic number");
    put(code, bytes);
    const fs::path frozen = folder / json["techniques"][1]["passes"][1]["pixel"]["frozen"].get<std::string>();
    put(frozen, "short");
    expect_refused(frozen, "the file ends after 5 bytes");
}

TEST_F(BrokenManifest, TextThatIsNoManifest) {
    for (const std::string text : {"", "{", "{\"format\": 1,}", "nonsense", "\xff\xfe", "{\"format\": 1}}"}) {
        put(manifest, text);
        expect_refused(manifest, "parse error at line 1");
    }
    put(manifest, "[]");
    expect_refused(manifest, "an object was expected, and this is array");
    put(manifest, "{}");
    expect_refused(manifest, "the field 'format' is missing");
    put(manifest, std::string(100000, '['));
    expect_refused(manifest, "parse error");
}

struct Damage {
    const char* name;
    const char* pointer;  ///< JSON pointer of the value that is replaced
    Json value;           ///< discarded: the field is erased
    const char* says;
};

void PrintTo(const Damage& damage, std::ostream* out) {
    *out << damage.name;
}

const Json erased = Json(Json::value_t::discarded);

TEST_F(BrokenManifest, WithoutComputeShadersLoadsAsBefore) {
    for (Json& technique : json["techniques"])
        for (Json& pass : technique["passes"]) pass.erase("compute");
    put(manifest, json.dump());
    const auto loaded = load_manifest(manifest);
    ASSERT_TRUE(loaded) << loaded.error().message;
    expect_same(loaded->tables(), everything::effect);
}

class DamagedManifest : public BrokenManifest, public testing::WithParamInterface<Damage> {};

TEST_P(DamagedManifest, IsRefusedWithThePlace) {
    const Damage& damage = GetParam();
    const Json::json_pointer place(damage.pointer);
    ASSERT_TRUE(json.contains(place)) << damage.pointer;
    if (damage.value.is_discarded())
        json[place.parent_pointer()].erase(place.back());
    else
        json[place] = damage.value;
    expect_refused(json, damage.says);
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedManifest,
    testing::Values(
        Damage{"OtherFormat", "/format", 1, "format: this is format 1, and only 2 is known here"},
        Damage{"FormatAsText", "/format", "1", "format: a whole number"},
        Damage{"NoModules", "/modules", erased, ": the field 'modules' is missing"},
        Damage{"ModulesAsObject", "/modules", Json::object(), "modules: an array was expected, and this is object"},
        Damage{"ModuleAsNumber", "/modules/1", 3, "modules[1]: an object was expected, and this is number"},
        Damage{"NoEntry", "/modules/0/entry", erased, "modules[0]: the field 'entry' is missing"},
        Damage{"EntryAsNull", "/modules/0/entry", nullptr, "modules[0].entry: a text was expected, and this is null"},
        Damage{"UnknownStage", "/modules/0/stage", "geometry",
               "modules[0].stage: 'geometry' is not one of vertex, pixel"},
        Damage{"FileElsewhere", "/modules/0/file", "../x.spv", "'../x.spv' does not name a file beside the manifest"},
        Damage{"FileOfRoot", "/modules/0/file", "/x.spv", "does not name a file beside the manifest"},
        Damage{"FileWithoutName", "/modules/0/file", "", "does not name a file beside the manifest"},
        Damage{"FiveComponents", "/modules/0/attributes/0/components", 5, "an attribute has 1 to 4 components"},
        Damage{"NegativeLocation", "/modules/0/attributes/0/location", -1, "location: a whole number"},
        Damage{"FractionOfId", "/modules/0/axes/0/id", 0.5, "modules[0].axes[0].id: a whole number"},
        Damage{"HugeBits", "/modules/0/axes/0/bits", 4294967296, "this is 4294967296"},
        Damage{"UnknownType", "/modules/0/axes/0/type", "double", "'double' is not one of bool, int, uint, float"},
        Damage{"ModuleTwice", "/modules/1/name", "vs_main", "modules[1]: the name 'vs_main' occurs twice"},
        Damage{"UnknownKind", "/resources/0/kind", "texture", "resources[0].kind: 'texture' is not one of"},
        Damage{"UnknownDimension", "/resources/1/dimension", "4d", "'4d' is not one of 1d, 2d, 3d, cube"},
        Damage{"NoSize", "/resources/0/size", erased, "resources[0]: the field 'size' is missing"},
        Damage{"ResourceTwice", "/resources/1/name", "Globals", "resources[1]: the name 'Globals' occurs twice"},
        Damage{"UnknownBlock", "/members/0/block", "Local",
               "members[0].block: there is no uniform block or storage buffer 'Local'"},
        Damage{"BlockIsSampler", "/members/0/block", "Sky", "there is no uniform block or storage buffer 'Sky'"},
        Damage{"MemberOutside", "/members/0/offset", 4294967295, "members[0]: the member ends beyond its block's"},
        Damage{"UnknownModule", "/techniques/0/passes/0/pixel/module", "ps",
               "techniques[0].passes[0].pixel.module: there is no module 'ps'"},
        Damage{"WrongStage", "/techniques/0/passes/0/pixel/module", "vs_main", "is of another stage"},
        Damage{"NoConstants", "/techniques/0/passes/0/pixel/constants", Json::array(), "these are not the axes of"},
        Damage{"OtherConstant", "/techniques/0/passes/0/pixel/constants/0/name", "bSkies", "these are not the axes of"},
        Damage{"OtherId", "/techniques/0/passes/0/pixel/constants/0/id", 9, "these are not the axes of"},
        Damage{"UnknownLive", "/techniques/1/passes/1/live/0", "Earth",
               "techniques[1].passes[1].live[0]: there is no resource 'Earth'"},
        Damage{"NoPixel", "/techniques/1/passes/0/pixel", erased, "passes[0]: the field 'pixel' is missing"},
        Damage{"UnknownState", "/techniques/0/passes/0/states/0/state", "CulMode",
               "states[0].state: 'CulMode' is not a state of Direct3D 9"},
        Damage{"StateWithoutIndex", "/techniques/0/passes/0/states/0/index", erased, "the field 'index' is missing"},
        Damage{"UnknownValueKind", "/techniques/0/passes/0/states/0/kind", "word",
               "states[0].kind: 'word' is not one of"},
        Damage{"WrongValueKind", "/techniques/0/passes/0/states/0/kind", "float",
               "states[0].kind: 'CullMode' has no value of the kind 'float'"},
        Damage{"UnknownValue", "/techniques/0/passes/0/states/0/bits", 9, "states[0].bits: 'CullMode' has no value 9"},
        Damage{"StateWithoutValue", "/techniques/0/passes/0/states/0/value", erased, "the field 'value' is missing"}),
    [](const auto& damage) { return std::string(damage.param.name); });

class DamagedComputeManifest : public BrokenManifest, public testing::WithParamInterface<Damage> {
protected:
    DamagedComputeManifest() : BrokenManifest("compute") {}
};

TEST_P(DamagedComputeManifest, IsRefusedWithThePlace) {
    const Damage& damage = GetParam();
    const Json::json_pointer place(damage.pointer);
    if (damage.value.is_discarded())
        json[place.parent_pointer()].erase(place.back());
    else
        json[place] = damage.value;
    expect_refused(json, damage.says);
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedComputeManifest,
    testing::Values(
        Damage{"NoGroupSize", "/modules/0/group_size", erased, "modules[0]: the field 'group_size' is missing"},
        Damage{"TwoSizes", "/modules/0/group_size", Json::array({8, 8}),
               "a thread group has three sizes, and these are 2"},
        Damage{"ZeroSize", "/modules/0/group_size/1", 0, "modules[0].group_size[1]: a size of a thread group is 1 to"},
        Damage{"NegativeSize", "/modules/0/group_size/2", -1, "modules[0].group_size[2]: a whole number"},
        Damage{"HugeSize", "/modules/0/group_size/0", 4294967295, "a size of a thread group is 1 to 1024"},
        Damage{"TooManyThreads", "/modules/0/group_size", Json::array({64, 64, 64}),
               "modules[0].group_size: a thread group has 1024 threads at most"},
        Damage{"GroupOfAPixelShader", "/modules/0/stage", "pixel", "only a compute module has a thread group"},
        Damage{"UnknownFormat", "/resources/2/format", "rgba15f",
               "resources[2].format: 'rgba15f' is not one of rgba32f"},
        Damage{"WritableAsNumber", "/resources/2/writable", 1, "true or false was expected, and this is 1"},
        Damage{"NoElementSize", "/resources/5/size", erased, "resources[5]: the field 'size' is missing"},
        Damage{"ComputeBesidesPixel", "/techniques/0/passes/0/pixel",
               Json{{"module", "cs_main"}, {"constants", Json::array()}}, "is of another stage"}),
    [](const auto& damage) { return std::string(damage.param.name); });

}  // namespace
}  // namespace permgen

#include "fixture.h"

#include <kit/fail.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "json_value.h"
#include "transforms.h"

namespace tyndall::rig {
namespace {

constexpr int maxSide = 4096;
constexpr std::size_t maxVertices = 1u << 20;
constexpr int deepest = 64;  // the deepest product takes 37; recursion this deep does not fill the stack

void readNumbers(const JsonValue& value, std::size_t depth, Numbers& numbers) {
    if (value.json().is_boolean()) {
        numbers.values.push_back(value.boolean() ? 1.0 : 0.0);
        return;
    }
    if (!value.json().is_array()) {
        numbers.values.push_back(value.number());
        return;
    }
    const auto list = value.list();
    if (list.empty()) value.fail("an empty list says nothing; leave it out");
    if (numbers.shape.size() == depth) numbers.shape.push_back(list.size());
    if (depth >= 3 || numbers.shape[depth] != list.size())
        value.fail("lists in a list must have equal lengths, and nest at most three deep");
    for (const JsonValue& inner : list) {
        if (inner.json().is_array() != list[0].json().is_array())
            inner.fail("numbers and lists do not mix in one list");
        readNumbers(inner, depth + 1, numbers);
    }
}

Numbers readConstant(const JsonValue& value) {
    if (isTransform(value)) return readTransform(value);
    Numbers numbers;
    readNumbers(value, 0, numbers);
    return numbers;
}

template <class Value>
Value choose(const JsonValue& value, std::initializer_list<std::pair<std::string_view, Value>> choices) {
    const std::string text = value.text();
    std::string known;
    for (const auto& [name, choice] : choices) {
        if (text == name) return choice;
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    value.fail("\"{}\" is not one of {}", text, known);
}

std::array<int, 2> readPair(const JsonValue& value, int maximum) {
    const auto list = value.list();
    if (list.size() != 2) value.fail("width and height are 2 numbers, not {}", list.size());
    return {list[0].integer(1, maximum), list[1].integer(1, maximum)};
}

std::array<float, 4> readColour(const JsonValue& value) {
    const auto list = value.list();
    if (list.size() != 3 && list.size() != 4) value.fail("a colour has 3 or 4 numbers, not {}", list.size());
    std::array<float, 4> colour{0.0f, 0.0f, 0.0f, 1.0f};
    for (std::size_t i = 0; i < list.size(); ++i) colour[i] = static_cast<float>(list[i].number());
    return colour;
}

TextureSource readTexture(const JsonValue& value, const std::filesystem::path& folder) {
    value.allowOnly({"image", "generate", "size", "colours", "cells", "seed"});
    if (value.has("image")) {
        if (value.members().size() != 1) value.fail("a texture with \"image\" has no other settings");
        return ImageFile{(folder / value.at("image").text()).string()};
    }
    Generated made;
    made.pattern = choose<Pattern>(value.at("generate"), {{"constant", Pattern::Constant},
                                                          {"checker", Pattern::Checker},
                                                          {"gradient", Pattern::Gradient},
                                                          {"noise", Pattern::Noise}});
    if (value.has("size")) {
        const auto size = readPair(value.at("size"), maxSide);
        made.width = size[0];
        made.height = size[1];
    }
    if (value.has("colours")) {
        const auto colours = value.at("colours").list();
        const std::size_t wanted = made.pattern == Pattern::Constant ? 1 : 2;
        if (colours.size() != wanted)
            value.at("colours").fail("{} colour(s) are needed, not {}", wanted, colours.size());
        for (std::size_t i = 0; i < wanted; ++i) made.colours[i] = readColour(colours[i]);
    } else if (made.pattern == Pattern::Constant) {
        value.fail("a constant texture has \"colours\": [[r, g, b, a]]");
    }
    if (value.has("cells")) made.cells = readPair(value.at("cells"), maxSide);
    if (value.has("seed")) made.seed = static_cast<std::uint32_t>(value.at("seed").integer(0, 2147483647));
    return made;
}

/// "position" as well as "POSITION0": upper case with its index, as permgen writes it.
std::string semanticName(std::string name) {
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) == 0) name += '0';
    return name;
}

ExplicitGeometry readGeometry(const JsonValue& value) {
    value.allowOnly({"vertices", "indices"});
    ExplicitGeometry geometry;
    std::size_t count = 0;
    for (const auto& [name, rows] : value.at("vertices").members()) {
        std::vector<std::vector<double>> vertices;
        for (const JsonValue& row : rows.list()) {
            vertices.emplace_back();
            for (const JsonValue& number : row.list()) vertices.back().push_back(number.number());
            if (vertices.back().empty() || vertices.back().size() > 4 || vertices.back().size() != vertices[0].size())
                row.fail("a vertex must have 1 to 4 numbers, the same count for all vertices");
        }
        if (vertices.empty() || vertices.size() > maxVertices)
            rows.fail("there are 1 to {} vertices, not {}", maxVertices, vertices.size());
        if (count != 0 && vertices.size() != count)
            rows.fail("there are {} vertices, but {} of another semantic; give each vertex both", vertices.size(),
                      count);
        count = vertices.size();
        geometry.vertices[semanticName(name)] = std::move(vertices);
    }
    if (geometry.vertices.empty()) value.at("vertices").fail("name at least one semantic");
    if (value.has("indices")) {
        for (const JsonValue& index : value.at("indices").list())
            geometry.indices.push_back(static_cast<std::uint32_t>(index.integer(0, static_cast<int>(count) - 1)));
    } else {
        for (std::uint32_t i = 0; i < count; ++i) geometry.indices.push_back(i);
    }
    if (geometry.indices.empty() || geometry.indices.size() % 3 != 0)
        value.fail("{} indices do not make triangles; give three for each", geometry.indices.size());
    return geometry;
}

void readTarget(const JsonValue& root, Fixture& fixture) {
    if (root.has("size")) {
        const auto size = readPair(root.at("size"), maxSide);
        fixture.width = static_cast<std::uint32_t>(size[0]);
        fixture.height = static_cast<std::uint32_t>(size[1]);
    }
    if (root.has("format"))
        fixture.format = choose<VkFormat>(root.at("format"), {{"rgba32f", VK_FORMAT_R32G32B32A32_SFLOAT},
                                                              {"rgba16f", VK_FORMAT_R16G16B16A16_SFLOAT},
                                                              {"rgba8", VK_FORMAT_R8G8B8A8_UNORM}});
    fixture.tolerance = fixture.format == VK_FORMAT_R8G8B8A8_UNORM        ? Tolerance::Byte
                        : fixture.format == VK_FORMAT_R16G16B16A16_SFLOAT ? Tolerance::Half
                                                                          : Tolerance::Float;
    if (root.has("clear")) fixture.clear = readColour(root.at("clear"));
    if (root.has("depth")) fixture.depth = root.at("depth").boolean();
}

Fixture read(const JsonValue& root, const std::string& path) {
    root.allowOnly({"size", "format", "clear", "depth", "constants", "textures", "geometry"});
    Fixture fixture;
    fixture.path = path;
    readTarget(root, fixture);
    if (root.has("constants"))
        for (const auto& [name, value] : root.at("constants").members()) fixture.constants[name] = readConstant(value);
    if (root.has("textures"))
        for (const auto& [name, value] : root.at("textures").members())
            fixture.textures[name] = readTexture(value, std::filesystem::path(path).parent_path());
    if (root.has("geometry")) {
        const JsonValue geometry = root.at("geometry");
        if (geometry.json().is_object())
            fixture.geometry = readGeometry(geometry);
        else
            fixture.geometry = choose<Shape>(geometry, {{"triangle", Shape::Triangle},
                                                        {"quad", Shape::Quad},
                                                        {"cube", Shape::Cube},
                                                        {"sphere", Shape::Sphere}});
    }
    return fixture;
}

JsonValue::Json parse(const std::string& text, const std::string& path) {
    const auto checkDepth = [&](int depth, JsonValue::Json::parse_event_t, const JsonValue::Json&) {
        if (depth > deepest)
            throw FixtureFault(fmt::format(
                "{}: brackets and braces are nested more than {} deep; no fixture needs that", path, deepest));
        return true;
    };
    return JsonValue::Json::parse(text, checkDepth, true, true);  // with comments
}

}  // namespace

Result<Fixture> readFixture(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return failWith(path + ": this is a folder; name a fixture file, as in " +
                        (std::filesystem::path(path) / "NAME.rig.json").string());
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file.is_open() || file.bad()) return failWith(path + ": cannot be read; name an existing fixture file");
    try {
        const JsonValue::Json json = parse(text, path);
        return read(JsonValue(json, path + ":"), path);
    } catch (const FixtureFault& fault) {
        return failWith(std::string(fault.what()));
    } catch (const JsonValue::Json::exception& error) {
        return failWith(path + ": this is not JSON: " + error.what());
    }
}

}  // namespace tyndall::rig

#include "glb.h"

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace tyndall::test {
namespace {

using nlohmann::json;

void append32(std::vector<unsigned char>& bytes, std::uint32_t value, bool bigEndian) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<unsigned char>(value >> (bigEndian ? 24 - 8 * i : 8 * i)));
}

std::uint32_t crc(std::span<const unsigned char> bytes) {
    std::uint32_t value = 0xFFFFFFFFu;
    for (const unsigned char byte : bytes) {
        value ^= byte;
        for (int bit = 0; bit < 8; ++bit) value = value >> 1 ^ (value & 1 ? 0xEDB88320u : 0u);
    }
    return ~value;
}

void appendChunk(std::vector<unsigned char>& png, const char* type, const std::vector<unsigned char>& data) {
    append32(png, static_cast<std::uint32_t>(data.size()), true);
    const std::size_t start = png.size();
    png.insert(png.end(), type, type + 4);
    png.insert(png.end(), data.begin(), data.end());
    append32(png, crc(std::span(png).subspan(start)), true);
}

/// The folder is made once for each process and removed when it ends.
const std::filesystem::path& folder() {
    struct Folder {
        std::filesystem::path path =
            std::filesystem::temp_directory_path() / ("tyndall_apps_" + std::to_string(getpid()));
        Folder() { std::filesystem::create_directories(path); }
        ~Folder() {
            std::error_code error;
            std::filesystem::remove_all(path, error);
        }
    };
    static const Folder made;
    return made.path;
}

}  // namespace

std::vector<unsigned char> encodePng(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgba) {
    std::vector<unsigned char> header;
    append32(header, width, true);
    append32(header, height, true);
    header.insert(header.end(), {8, 6, 0, 0, 0});  // 8 bits, RGBA
    std::vector<unsigned char> raw;
    for (std::uint32_t row = 0; row < height; ++row) {
        raw.push_back(0);  // no filter
        raw.insert(raw.end(), rgba.begin() + 4 * width * row, rgba.begin() + 4 * width * (row + 1));
    }
    std::vector<unsigned char> zlib = {0x78, 0x01};
    std::uint32_t a = 1, b = 0;
    for (std::size_t at = 0; at < raw.size();) {  // stored blocks: RFC 1951, 3.2.4
        const std::size_t size = std::min<std::size_t>(raw.size() - at, 65535);
        zlib.push_back(at + size == raw.size());
        for (const std::size_t length : {size, ~size}) {
            zlib.push_back(static_cast<unsigned char>(length));
            zlib.push_back(static_cast<unsigned char>(length >> 8));
        }
        for (std::size_t end = at + size; at < end; ++at) {
            zlib.push_back(raw[at]);
            a = (a + raw[at]) % 65521;
            b = (b + a) % 65521;
        }
    }
    append32(zlib, b << 16 | a, true);
    std::vector<unsigned char> png = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};
    appendChunk(png, "IHDR", header);
    appendChunk(png, "IDAT", zlib);
    appendChunk(png, "IEND", {});
    return png;
}

std::size_t Glb::addView(std::span<const unsigned char> bytes) {
    const std::size_t offset = binary.size();
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    while (binary.size() % 4 != 0) binary.push_back(0);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
    json["buffers"] = nlohmann::json::array({{{"byteLength", binary.size()}}});
    return json["bufferViews"].size() - 1;
}

std::size_t Glb::addFloats(const std::vector<float>& values, const std::string& type) {
    const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    const std::size_t view = addView({bytes, 4 * values.size()});
    json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", 5126}, {"count", values.size() / components}, {"type", type}});
    return json["accessors"].size() - 1;
}

std::size_t Glb::addIndices(const std::vector<std::uint16_t>& values) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    const std::size_t view = addView({bytes, 2 * values.size()});
    json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", 5123}, {"count", values.size()}, {"type", "SCALAR"}});
    return json["accessors"].size() - 1;
}

std::size_t Glb::addTexture(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgba) {
    const std::size_t view = addView(encodePng(width, height, rgba));
    json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    json["textures"].push_back({{"source", json["images"].size() - 1}});
    return json["textures"].size() - 1;
}

std::size_t Glb::addSquare(float h) {
    const std::size_t positions = addFloats({-h, -h, 0, h, -h, 0, h, h, 0, -h, h, 0}, "VEC3");
    json["accessors"][positions]["min"] = {-h, -h, 0};
    json["accessors"][positions]["max"] = {h, h, 0};
    const std::size_t uv = addFloats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
    const std::size_t indices = addIndices({0, 1, 2, 0, 2, 3});
    json["meshes"].push_back(
        {{"name", "Square"},
         {"primitives", {{{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uv}}}, {"indices", indices}}}}});
    return json["meshes"].size() - 1;
}

std::size_t Glb::addNode(nlohmann::json node) {
    json["nodes"].push_back(std::move(node));
    const std::size_t index = json["nodes"].size() - 1;
    json["scenes"][0]["nodes"].push_back(index);
    return index;
}

std::vector<unsigned char> Glb::bytes() const {
    std::string text = json.dump();
    while (text.size() % 4 != 0) text.push_back(' ');
    std::vector<unsigned char> all;
    const std::size_t total = 12 + 8 + text.size() + (binary.empty() ? 0 : 8 + binary.size());
    append32(all, 0x46546C67u, false);
    append32(all, 2, false);
    append32(all, static_cast<std::uint32_t>(total), false);
    append32(all, static_cast<std::uint32_t>(text.size()), false);
    append32(all, 0x4E4F534Au, false);
    all.insert(all.end(), text.begin(), text.end());
    if (binary.empty()) return all;
    append32(all, static_cast<std::uint32_t>(binary.size()), false);
    append32(all, 0x004E4942u, false);
    all.insert(all.end(), binary.begin(), binary.end());
    return all;
}

Glb wallScene() {
    Glb glb;
    glb.json["asset"] = {{"version", "2.0"}};
    glb.json["scene"] = 0;
    glb.json["scenes"] = json::array({{{"nodes", json::array()}}});
    glb.json["extensionsUsed"] = {"KHR_lights_punctual"};
    glb.json["cameras"] = json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}});
    glb.json["extensions"]["KHR_lights_punctual"]["lights"] = json::array(
        {{{"type", "spot"}, {"intensity", 100.0}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.35}}}}});
    const std::size_t square = glb.addSquare(4.0f);
    glb.addNode({{"name", "Wall"}, {"mesh", square}, {"translation", {0, 0, -5}}});
    glb.addNode({{"name", "Eye"}, {"camera", 0}});
    glb.addNode({{"name", "Lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return glb;
}

std::string freshPath(const std::string& name) {
    static int count = 0;
    const std::filesystem::path own = folder() / std::to_string(count++);
    std::filesystem::create_directories(own);
    return (own / name).string();
}

std::string writeBytes(std::span<const unsigned char> bytes, const std::string& name) {
    const std::string path = freshPath(name);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
}

std::string writeScene(const Glb& glb, const std::string& name) {
    return writeBytes(glb.bytes(), name);
}

}  // namespace tyndall::test

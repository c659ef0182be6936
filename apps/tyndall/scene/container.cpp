#include "container.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace tyndall::app {
namespace {

constexpr std::uint32_t glbMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t jsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t binChunk = 0x004E4942;   // "BIN\0"
constexpr std::size_t headerBytes = 12, chunkHeaderBytes = 8;
constexpr int deepestNesting = 64;
constexpr std::uintmax_t largestFile = std::uintmax_t{1} << 31;  // tinygltf counts in 32 bits

std::uint32_t word(const std::vector<unsigned char>& bytes, std::size_t offset) {
    return std::uint32_t{bytes[offset]} | std::uint32_t{bytes[offset + 1]} << 8 |
           std::uint32_t{bytes[offset + 2]} << 16 | std::uint32_t{bytes[offset + 3]} << 24;
}

Result<std::vector<unsigned char>> readBytes(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) return fail("{}: no such file; check the path of the scene", path);
    if (!std::filesystem::is_regular_file(status))
        return fail("{}: not a file; name a .glb or .gltf file, not a folder or device", path);
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) return fail(ErrorCode::File, "{}: cannot be read: {}", path, error.message());
    if (size > largestFile) return fail("{}: is larger than 2 GiB; split the scene or shrink its textures", path);

    std::ifstream file(path, std::ios::binary);
    if (!file) return fail("{}: cannot be opened: {}; check its permissions", path, std::strerror(errno));
    std::vector<unsigned char> bytes(size);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(file.gcount()) != size)
        return fail("{}: only {} of its {} bytes could be read", path, file.gcount(), size);
    return bytes;
}

}  // namespace

Result<Container> readContainer(const std::string& path) {
    auto bytes = readBytes(path);
    if (!bytes) return tl::unexpected(bytes.error());
    Container container;
    container.bytes = std::move(*bytes);
    const auto& data = container.bytes;

    if (data.size() < 4) return fail("{}: has {} bytes, too few for any glTF file; export it again", path, data.size());
    if (word(data, 0) != glbMagic) {
        const std::size_t first = container.bytes.size() >= 3 && data[0] == 0xEF && data[1] == 0xBB ? 3 : 0;  // BOM
        container.jsonOffset = first;
        container.jsonLength = data.size() - first;
        if (container.json().find_first_not_of(" \t\r\n") == std::string_view::npos ||
            container.json()[container.json().find_first_not_of(" \t\r\n")] != '{')
            return fail("{}: is neither glTF binary nor glTF JSON; name a .glb or .gltf file", path);
        return container;
    }

    container.binary = true;
    if (data.size() < headerBytes + chunkHeaderBytes)
        return fail("{}: is cut short: {} bytes are fewer than a .glb's headers; copy or export it again", path,
                    data.size());
    if (word(data, 4) != 2)
        return fail("{}: is glTF binary version {}, and only version 2 is read; export it as glTF 2.0", path,
                    word(data, 4));
    const std::size_t length = word(data, 8);
    if (data.size() < length)
        return fail("{}: is cut short: it has {} of the {} bytes that its header states; copy or export it again", path,
                    data.size(), length);
    container.jsonOffset = headerBytes + chunkHeaderBytes;
    container.jsonLength = word(data, headerBytes);
    if (word(data, headerBytes + 4) != jsonChunk || container.jsonLength > length ||
        container.jsonOffset + container.jsonLength > length)
        return fail("{}: its JSON chunk is damaged; export the file again", path);

    const std::size_t next = container.jsonOffset + container.jsonLength;
    if (next == length) return container;
    if (next + chunkHeaderBytes > length || word(data, next + 4) != binChunk ||
        word(data, next) > length - next - chunkHeaderBytes)
        return fail("{}: its binary chunk is damaged; export the file again", path);
    container.binaryLength = word(data, next);
    return container;
}

bool nestingIsSane(std::string_view json) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (inString) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            if (++depth > deepestNesting) return false;
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return true;
}

}  // namespace tyndall::app

#include "document.h"

#include <cstring>
#include <filesystem>

#include "check_document.h"
#include "container.h"

namespace tyndall::app {
namespace {

constexpr std::uint32_t longestImageSide = 16384;
constexpr std::uint64_t mostImageTexels = std::uint64_t{1} << 26;

std::uint32_t bigEndian(const unsigned char* bytes, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) value = value << 8 | bytes[i];
    return value;
}

/// Width and height as a PNG or JPEG header states them, before anything of that size is allocated.
std::optional<std::pair<std::uint32_t, std::uint32_t>> statedSize(const unsigned char* bytes, std::size_t size) {
    static constexpr unsigned char png[] = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};
    if (size >= 24 && std::memcmp(bytes, png, sizeof png) == 0)
        return std::pair{bigEndian(bytes + 16, 4), bigEndian(bytes + 20, 4)};
    if (size < 4 || bytes[0] != 0xFF || bytes[1] != 0xD8) return std::nullopt;
    for (std::size_t at = 2; at + 9 <= size && bytes[at] == 0xFF;) {
        const unsigned char marker = bytes[at + 1];
        if (marker == 0xFF) {  // fill byte
            ++at;
            continue;
        }
        const bool frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (frame) return std::pair{bigEndian(bytes + at + 7, 2), bigEndian(bytes + at + 5, 2)};
        at += 2 + bigEndian(bytes + at + 2, 2);
    }
    return std::nullopt;
}

bool loadImage(tinygltf::Image* image, int index, std::string* error, std::string* warning, int width, int height,
               const unsigned char* bytes, int size, void*) {
    const auto stated = statedSize(bytes, size > 0 ? static_cast<std::size_t>(size) : 0);
    if (!stated) {
        *error += fmt::format("image {} is neither PNG nor JPEG; export the textures as one of these", index);
        return false;
    }
    if (stated->first > longestImageSide || stated->second > longestImageSide ||
        std::uint64_t{stated->first} * stated->second > mostImageTexels) {
        *error += fmt::format("image {} is {}x{} texels; at most {} a side and {} in all are read", index,
                              stated->first, stated->second, longestImageSide, mostImageTexels);
        return false;
    }
    std::string reason;
    if (tinygltf::LoadImageData(image, index, &reason, warning, width, height, bytes, size, nullptr)) return true;
    *error += fmt::format("image {} cannot be decoded; save it again as PNG or JPEG", index);
    return false;
}

std::string oneLine(std::string text) {
    for (char& c : text)
        if (c == '\n') c = ' ';
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

}  // namespace

Outcome<Document> readDocument(const std::string& path) {
    auto container = readContainer(path);
    if (!container) return tl::unexpected(container.error());
    if (!nestingIsSane(container->json()))
        return fail("{}: its JSON nests too deep for a glTF file; remove what is nested in extras", path);

    Document document;
    try {
        document.json = nlohmann::json::parse(container->json());
        if (auto checked = checkDocument(document.json, container->binary, container->binaryLength); !checked)
            return fail("{}: {}", path, checked.error());

        tinygltf::TinyGLTF reader;
        reader.SetImageLoader(loadImage, nullptr);
        std::string error;
        const std::string folder = std::filesystem::path(path).parent_path().string();
        const auto size = static_cast<unsigned int>(container->bytes.size());
        const bool read = container->binary ? reader.LoadBinaryFromMemory(&document.model, &error, &document.warnings,
                                                                          container->bytes.data(), size, folder)
                                            : reader.LoadASCIIFromString(
                                                  &document.model, &error, &document.warnings, container->json().data(),
                                                  static_cast<unsigned int>(container->jsonLength), folder);
        if (!read) return fail("{}: {}", path, oneLine(error));
        document.warnings = oneLine(document.warnings);
    } catch (const nlohmann::json::exception& broken) {
        return fail("{}: its JSON is damaged ({}); export the file again", path, oneLine(broken.what()));
    } catch (const std::bad_alloc&) {
        return fail("{}: needs more memory than there is; shrink its textures and meshes", path);
    } catch (const std::exception& broken) {
        return fail("{}: cannot be read ({}); export the file again", path, oneLine(broken.what()));
    }
    return document;
}

}  // namespace tyndall::app

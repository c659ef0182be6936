#include "document.h"

#include <filesystem>

#include "check_document.h"
#include "container.h"
#include "decode_image.h"

namespace tyndall::app {
namespace {

std::string oneLine(std::string text) {
    for (char& c : text)
        if (c == '\n') c = ' ';
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

}  // namespace

Result<Document> readDocument(const std::string& path) {
    auto container = readContainer(path);
    if (!container) return tl::unexpected(container.error());
    if (!nestingIsSane(container->json()))
        return fail("{}: its JSON nests too deep for a glTF file; remove what is nested in extras", path);

    Document document;
    try {
        document.json = nlohmann::json::parse(container->json());
        if (auto checked = checkDocument(document.json, container->binary, container->binaryLength); !checked)
            return passOn(checked.error(), path);

        tinygltf::TinyGLTF reader;
        reader.SetImageLoader(keepEncoded, nullptr);
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
        return fail("{}: needs too much memory; shrink its textures and meshes", path);
    } catch (const std::exception& broken) {
        return fail(ErrorCode::File, "{}: cannot be read ({}); export the file again", path, oneLine(broken.what()));
    }
    return document;
}

}  // namespace tyndall::app

#include "write_picture.h"

#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

#include "tone_map.h"

namespace tyndall::app {
namespace {

/// In the same folder, so that the rename stays within one file system; with the extension kept, by which
/// the image library knows the format.
std::string besidePath(const std::string& path) {
    const std::filesystem::path whole(path);
    const std::string name =
        fmt::format(".{}.{}.partial{}", whole.stem().string(), ::getpid(), whole.extension().string());
    return (whole.parent_path() / name).string();
}

Outcome<void> writeBeside(const std::string& path, const std::function<Outcome<void>(const std::string&)>& write) {
    const std::string partial = besidePath(path);
    std::error_code error;
    auto written = write(partial);
    if (written) {
        std::filesystem::rename(partial, path, error);
        if (!error) return {};
        written = fail("{}: cannot be written: {}; choose another place", path, error.message());
    }
    std::filesystem::remove(partial, error);
    return written;
}

Outcome<void> saveImage(const std::string& partial, const std::string& path, const Picture& picture,
                        OIIO::TypeDesc type, const void* pixels) {
    auto file = OIIO::ImageOutput::create(partial);
    if (!file) return fail("{}: cannot be written: {}", path, OIIO::geterror());
    OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height), 3, type);
    spec.attribute("oiio:ColorSpace", type == OIIO::TypeDesc::UINT8 ? "sRGB" : "Linear");
    if (!file->open(partial, spec) || !file->write_image(type, pixels) || !file->close())
        return fail("{}: cannot be written: {}; choose another place", path, file->geterror());
    return {};
}

}  // namespace

std::optional<PictureFormat> pictureFormat(std::string_view path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".png") return PictureFormat::Png;
    if (extension == ".exr") return PictureFormat::Exr;
    return std::nullopt;
}

Outcome<void> checkWritable(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return fail("{}: is a folder; name a file", path);
    // The rename that ends the writing would put a plain file in a device's or a pipe's place.
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
        return fail("{}: is no plain file; choose another place", path);
    const std::string partial = besidePath(path);
    errno = 0;
    const bool opened = std::ofstream(partial).is_open();
    const int reason = errno;
    if (!opened) return fail("{}: cannot be written: {}; choose another place", path, std::strerror(reason));
    std::filesystem::remove(partial, error);
    return {};
}

Outcome<void> writePicture(const std::string& path, const Picture& picture, std::optional<double> exposureStops) {
    const auto format = pictureFormat(path);
    if (!format) return fail("{}: pictures are written as .png or .exr; change the extension", path);
    if (const BadPixels bad = findBadPixels(picture); bad.count > 0)
        return fail(
            "{}: {} pixels are not finite numbers, the first at ({}, {}), so nothing was written; "
            "this is a fault of the renderer, please report it with the scene",
            path, bad.count, bad.x, bad.y);
    return writeBeside(path, [&](const std::string& partial) {
        if (*format == PictureFormat::Exr)
            return saveImage(partial, path, picture, OIIO::TypeDesc::FLOAT, picture.pixels.data());
        const std::vector<std::uint8_t> bytes = displayBytes(picture, exposureStops);
        return saveImage(partial, path, picture, OIIO::TypeDesc::UINT8, bytes.data());
    });
}

Outcome<void> writeText(const std::string& path, std::string_view text) {
    return writeBeside(path, [&](const std::string& partial) -> Outcome<void> {
        std::ofstream file(partial, std::ios::binary);
        file << text;
        file.close();
        if (!file) return fail("{}: cannot be written: {}; choose another place", path, std::strerror(errno));
        return {};
    });
}

}  // namespace tyndall::app

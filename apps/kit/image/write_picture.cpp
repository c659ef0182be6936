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

namespace tyndall {
namespace {

/// Where the links that `path` may be lead: links to come and links that point at nothing included.
Result<std::filesystem::path> written(const std::string& path) {
    constexpr int mostLinks = 40;  // as many as Linux follows
    std::filesystem::path at(path);
    for (int links = 0; links < mostLinks; ++links) {
        std::error_code error;
        if (!std::filesystem::is_symlink(at, error)) return at;
        const std::filesystem::path next = std::filesystem::read_symlink(at, error);
        if (error) return at;
        at = next.is_absolute() ? next : at.parent_path() / next;
    }
    return fail("{}: is a link that leads round in a circle; choose another place", path);
}

/// In the same folder, so that the rename stays within one file system; with the extension of what was asked
/// for kept, by which the image library knows the format.
std::string besidePath(const std::filesystem::path& whole, const std::string& asked) {
    const std::string name = fmt::format(".{}.{}.partial{}", whole.stem().string(), ::getpid(),
                                         std::filesystem::path(asked).extension().string());
    return (whole.parent_path() / name).string();
}

Result<void> writeBeside(const std::string& path, const std::function<Result<void>(const std::string&)>& write) {
    const auto target = written(path);
    if (!target) return tl::unexpected(target.error());
    const std::string partial = besidePath(*target, path);
    std::error_code error;
    auto done = write(partial);
    if (done) {
        std::filesystem::rename(partial, *target, error);
        if (!error) return {};
        done = fail("{}: cannot be written: {}; choose another place", path, error.message());
    }
    std::filesystem::remove(partial, error);
    return done;
}

/// Pixels as they lie in memory, and what they are.
struct Raster {
    int width, height;
    std::vector<std::string> channels;
    OIIO::TypeDesc type;
    const void* pixels;
};

Result<void> saveImage(const std::string& partial, const std::string& path, const Raster& raster) {
    auto file = OIIO::ImageOutput::create(partial);
    if (!file) return fail("{}: cannot be written: {}", path, OIIO::geterror());
    OIIO::ImageSpec spec(raster.width, raster.height, static_cast<int>(raster.channels.size()), raster.type);
    spec.channelnames = raster.channels;
    spec.attribute("DateTime", "");  // or the library writes the present one, and no two files are alike
    spec.attribute("oiio:ColorSpace", raster.type == OIIO::TypeDesc::UINT8 ? "sRGB" : "Linear");
    if (!file->open(partial, spec) || !file->write_image(raster.type, raster.pixels) || !file->close())
        return fail("{}: cannot be written: {}; choose another place", path, file->geterror());
    return {};
}

const std::vector<std::string> redGreenBlue = {"R", "G", "B"};

}  // namespace

std::optional<PictureFormat> pictureFormat(std::string_view path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".png") return PictureFormat::Png;
    if (extension == ".exr") return PictureFormat::Exr;
    return std::nullopt;
}

Result<void> checkWritable(const std::string& path) {
    std::error_code error;
    const auto target = written(path);
    if (!target) return tl::unexpected(target.error());
    if (std::filesystem::is_directory(*target, error)) return fail("{}: is a folder; name a file", path);
    // The rename that ends the writing would put a plain file in a device's or a pipe's place.
    if (std::filesystem::exists(*target, error) && !std::filesystem::is_regular_file(*target, error))
        return fail("{}: is no plain file; choose another place", path);
    const std::string partial = besidePath(*target, path);
    errno = 0;
    const bool opened = std::ofstream(partial).is_open();
    const int reason = errno;
    if (!opened) return fail("{}: cannot be written: {}; choose another place", path, std::strerror(reason));
    std::filesystem::remove(partial, error);
    return {};
}

bool sameFile(const std::string& a, const std::string& b) {
    std::error_code error;
    if (std::filesystem::equivalent(a, b, error)) return true;
    const auto first = written(a), second = written(b);
    return first && second &&
           std::filesystem::weakly_canonical(*first, error) == std::filesystem::weakly_canonical(*second, error);
}

Result<void> writePicture(const std::string& path, const Picture& picture, std::optional<double> exposureStops) {
    const auto format = pictureFormat(path);
    if (!format) return fail("{}: pictures are written as .png or .exr; change the extension", path);
    if (const BadPixels bad = findBadPixels(picture); bad.count > 0)
        return fail(
            "{}: {} pixels are not finite numbers, the first at ({}, {}), so nothing was written; 32-bit floats end at "
            "3.4e38: lower the scene's intensities and densities, or report the scene where they are ordinary",
            path, bad.count, bad.x, bad.y);
    if (*format == PictureFormat::Png)
        return writeBytes(path, picture.width, picture.height, displayBytes(picture, exposureStops));
    const Raster raster{static_cast<int>(picture.width), static_cast<int>(picture.height), redGreenBlue,
                        OIIO::TypeDesc::FLOAT, picture.pixels.data()};
    return writeBeside(path, [&](const std::string& partial) { return saveImage(partial, path, raster); });
}

Result<void> writeFloats(const std::string& path, const study::FloatImage& image,
                          const std::vector<std::string>& channels) {
    const Raster raster{image.width, image.height, channels, OIIO::TypeDesc::FLOAT, image.values.data()};
    return writeBeside(path, [&](const std::string& partial) { return saveImage(partial, path, raster); });
}

Result<void> writeBytes(const std::string& path, std::uint32_t width, std::uint32_t height,
                         const std::vector<std::uint8_t>& rgb) {
    const Raster raster{static_cast<int>(width), static_cast<int>(height), redGreenBlue, OIIO::TypeDesc::UINT8,
                        rgb.data()};
    return writeBeside(path, [&](const std::string& partial) { return saveImage(partial, path, raster); });
}

Result<void> writeText(const std::string& path, std::string_view text) {
    return writeBeside(path, [&](const std::string& partial) -> Result<void> {
        std::ofstream file(partial, std::ios::binary);
        file << text;
        file.close();
        if (!file) return fail("{}: cannot be written: {}; choose another place", path, std::strerror(errno));
        return {};
    });
}

}  // namespace tyndall

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <kit/image/files.h>
#include <kit/image/tone_map.h>
#include <kit/image/write_picture.h>

#include <cctype>
#include <filesystem>

namespace tyndall {
namespace {

/// Pixels as they lie in memory, and what they are.
struct Raster {
    int width, height;
    std::vector<std::string> channels;
    OIIO::TypeDesc type;
    const void* pixels;
};

Result<void> writeRaster(const std::string& path, const Raster& raster) {
    OIIO::Filesystem::IOVecOutput bytes;
    const bool png = raster.type == OIIO::TypeDesc::UINT8;
    auto file = OIIO::ImageOutput::create(png ? "png" : "openexr");
    if (!file) return fail(ErrorCode::File, "{}: cannot be written: {}", path, OIIO::geterror());
    OIIO::ImageSpec spec(raster.width, raster.height, static_cast<int>(raster.channels.size()), raster.type);
    spec.channelnames = raster.channels;
    spec.attribute("DateTime", "");  // the library would write the current time, and no two files would be equal
    spec.attribute("oiio:ColorSpace", png ? "sRGB" : "Linear");
    if (!png) spec.attribute("compression", "zip");
    if (!file->set_ioproxy(&bytes) || !file->open(png ? "memory.png" : "memory.exr", spec) ||
        !file->write_image(raster.type, raster.pixels) || !file->close())
        return fail(ErrorCode::File, "{}: cannot be written: {}; choose another place", path, file->geterror());
    const auto& whole = bytes.buffer();
    return writeFile(path, {reinterpret_cast<const char*>(whole.data()), whole.size()});
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

Result<void> writePicture(const std::string& path, const Image& picture, std::optional<double> exposureStops) {
    const auto format = pictureFormat(path);
    if (!format) return fail("{}: pictures are written as .png or .exr; change the extension", path);
    if (const BadPixels bad = findBadPixels(picture); bad.count > 0)
        return fail(
            "{}: {} pixels are not finite numbers, the first at ({}, {}), so nothing was written; 32-bit floats end at "
            "3.4e38: lower the scene's intensities and densities, or report the scene where they are ordinary",
            path, bad.count, bad.x, bad.y);
    if (*format == PictureFormat::Png)
        return writePng(path, picture.width, picture.height, displayBytes(picture, exposureStops));
    return writeExr(path, picture, redGreenBlue);
}

Result<void> writeExr(const std::string& path, const Image& image, std::vector<std::string> channels) {
    if (channels.empty()) channels = OIIO::ImageSpec(image.width, image.height, image.channels).channelnames;
    return writeRaster(path, {image.width, image.height, channels, OIIO::TypeDesc::FLOAT, image.values.data()});
}

Result<void> writePng(const std::string& path, int width, int height, const std::vector<std::uint8_t>& rgb) {
    return writeRaster(path, {width, height, redGreenBlue, OIIO::TypeDesc::UINT8, rgb.data()});
}

}  // namespace tyndall

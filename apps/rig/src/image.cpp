#include <kit/fail.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <rig/image.h>
#include <unistd.h>

#include <filesystem>

namespace tyndall::rig {
namespace {

constexpr int longestSide = 16384;

/// In the same folder, so that the rename stays within one file system; the extension tells the format.
std::string besidePath(const std::string& path) {
    const std::filesystem::path whole(path);
    const std::string name =
        fmt::format(".{}.{}.partial{}", whole.stem().string(), ::getpid(), whole.extension().string());
    return (whole.parent_path() / name).string();
}

Result<void> write(const std::string& path, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels) {
    const std::string partial = besidePath(path);
    std::string reason;
    {
        auto file = OIIO::ImageOutput::create(partial);
        if (!file)
            reason = OIIO::geterror();
        else if (!file->open(partial, spec) || !file->write_image(type, pixels) || !file->close())
            reason = file->geterror();
    }
    std::error_code error;
    if (reason.empty()) {
        std::filesystem::rename(partial, path, error);
        if (!error) return {};
        reason = error.message();
    }
    std::filesystem::remove(partial, error);
    return failWith(fmt::format("{}: cannot be written: {}; choose another place", path, reason));
}

}  // namespace

Image blankImage(int width, int height, int channels) {
    return {width, height, channels, std::vector<float>(static_cast<std::size_t>(width) * height * channels)};
}

Result<Image> readImage(const std::string& path) {
    auto file = OIIO::ImageInput::open(path);
    if (!file) {
        std::error_code ignored;
        const bool there = std::filesystem::exists(path, ignored);
        const std::string reason = OIIO::geterror();  // asked for in any case, or it is printed at the end
        return failWith(fmt::format("{}: cannot be read: {}", path, there ? reason : "there is no such file"));
    }
    const OIIO::ImageSpec& spec = file->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > longestSide || spec.height > longestSide || spec.depth > 1)
        return failWith(fmt::format("{}: {} x {} pixels are no image of 1 to {} a side; resize it", path,
                                          spec.width, spec.height, longestSide));
    if (spec.nchannels < 1 || spec.nchannels > 4)
        return failWith(fmt::format("{}: it has {} channels; save it with 1 to 4", path, spec.nchannels));
    Image image = blankImage(spec.width, spec.height, spec.nchannels);
    if (!file->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.values.data()))
        return failWith(fmt::format("{}: cannot be read: {}", path, file->geterror()));
    return image;
}

Result<void> writeExr(const std::string& path, const Image& image) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zip");
    return write(path, spec, OIIO::TypeDesc::FLOAT, image.values.data());
}

Result<void> writePng(const std::string& path, int width, int height, const std::vector<std::uint8_t>& rgb) {
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return write(path, spec, OIIO::TypeDesc::UINT8, rgb.data());
}

}  // namespace tyndall::rig

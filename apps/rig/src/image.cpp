#include <OpenImageIO/imageio.h>
#include <kit/fail.h>
#include <rig/image.h>

#include <filesystem>

namespace tyndall::rig {

Result<Image> readImage(const std::string& path) {
    auto file = OIIO::ImageInput::open(path);
    if (!file) {
        std::error_code ignored;
        const bool there = std::filesystem::exists(path, ignored);
        const std::string reason = OIIO::geterror();  // always read, else OpenImageIO prints it at exit
        return failWith(fmt::format("{}: cannot be read: {}", path, there ? reason : "there is no such file"));
    }
    constexpr int side = static_cast<int>(longestSide);
    const OIIO::ImageSpec& spec = file->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > side || spec.height > side || spec.depth > 1)
        return failWith(fmt::format("{}: {} x {} pixels, each side must be from 1 to {}; resize it", path, spec.width,
                                    spec.height, side));
    if (spec.nchannels < 1 || spec.nchannels > 4)
        return failWith(fmt::format("{}: it has {} channels; save it with 1 to 4", path, spec.nchannels));
    Image image = blankImage(spec.width, spec.height, spec.nchannels);
    if (!file->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.values.data()))
        return failWith(fmt::format("{}: cannot be read: {}", path, file->geterror()));
    return image;
}

}  // namespace tyndall::rig

#include <OpenImageIO/imageio.h>
#include <kit/image/image.h>
#include <kit/image/read_picture.h>
#include <kit/image/srgb.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace tyndall {
namespace {

constexpr int maxChannels = 64;
/// 4 GiB of floats: a broken header of a few bytes must not allocate all memory.
constexpr std::size_t maxValues = std::size_t{1} << 30;

/// The image library's name of the format, found from the file's first bytes.
Result<const char*> formatOf(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        return fail(ErrorCode::File, "{}: is a folder; name a picture", path);
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
        return fail(ErrorCode::File, "{}: is not a plain file; name a picture", path);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) return fail(ErrorCode::File, "{}: cannot be read: {}; check the path", path, std::strerror(errno));
    std::array<char, 4> start{};
    file.read(start.data(), start.size());
    if (std::memcmp(start.data(), "\x76\x2f\x31\x01", 4) == 0) return "openexr";
    if (std::memcmp(start.data(), "\x89PNG", 4) == 0) return "png";
    return fail("{}: is neither OpenEXR nor PNG; convert it to one of them", path);
}

/// The image library's message, as a part of a sentence.
std::string reason(OIIO::ImageInput& file) {
    std::string text = file.geterror();
    text = text.substr(0, text.find('\n'));
    return text.empty() ? "its content is broken" : text;
}

Result<void> checkLayout(const std::string& path, const OIIO::ImageSpec& spec, bool severalParts) {
    if (severalParts) return fail("{}: has several parts; extract one part into a file of its own", path);
    if (spec.deep) return fail("{}: holds deep samples; flatten it first", path);
    const int side = static_cast<int>(longestSide);
    if (spec.width < 1 || spec.height < 1 || spec.width > side || spec.height > side)
        return fail("{}: is {}x{} pixels; each side must be from 1 to {}", path, spec.width, spec.height, side);
    if (spec.nchannels < 1 || spec.nchannels > maxChannels)
        return fail("{}: has {} channels; from 1 to {} can be compared", path, spec.nchannels, maxChannels);
    if (static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels > maxValues)
        return fail("{}: is {}x{} pixels of {} channels, more than {} values; cut it into parts", path, spec.width,
                    spec.height, spec.nchannels, maxValues);
    if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
        spec.height != spec.full_height)
        return fail(
            "{}: its data window ({}x{} from ({}, {})) is not its display window ({}x{} from ({}, {})); crop or "
            "fill it, so that pixels have one place",
            path, spec.width, spec.height, spec.x, spec.y, spec.full_width, spec.full_height, spec.full_x, spec.full_y);
    return {};
}

Result<std::string> exrEncoding(const std::string& path, const OIIO::ImageSpec& spec) {
    bool half = true, single = true;
    for (int c = 0; c < spec.nchannels; ++c) {
        const OIIO::TypeDesc type = spec.channelformat(c);
        if (type != OIIO::TypeDesc::HALF && type != OIIO::TypeDesc::FLOAT)
            return fail("{}: its channel {} holds integers, not light; leave it out", path, spec.channel_name(c));
        half = half && type == OIIO::TypeDesc::HALF;
        single = single && type == OIIO::TypeDesc::FLOAT;
    }
    return std::string(half ? "16-bit float" : single ? "32-bit float" : "16- and 32-bit float");
}

void decodeSrgb(Image& image, int alpha) {
    for (std::size_t k = 0; k < image.values.size(); ++k)
        if (static_cast<int>(k % image.channels) != alpha) image.values[k] = linearFromSrgb(image.values[k]);
}

}  // namespace

Result<ReadPicture> readPicture(const std::string& path) {
    const auto format = formatOf(path);
    if (!format) return tl::unexpected(format.error());
    const bool png = std::string_view(*format) == "png";
    auto file = OIIO::ImageInput::create(*format);
    if (!file) return fail(ErrorCode::File, "{}: cannot be read: {}", path, OIIO::geterror());
    OIIO::ImageSpec spec, settings;
    settings.attribute("oiio:UnassociatedAlpha", 1);  // colours are compared as stored
    if (!file->open(path, spec, settings)) return fail(ErrorCode::File, "{}: cannot be read: {}", path, reason(*file));
    const bool severalParts = file->seek_subimage(1, 0);
    if (!severalParts) file->geterror();  // the error is expected
    if (auto checked = checkLayout(path, spec, severalParts); !checked) return tl::unexpected(checked.error());

    ReadPicture picture;
    picture.encoding = fmt::format("{} bits, decoded from sRGB", spec.format.size() * 8);
    if (!png) {
        auto encoding = exrEncoding(path, spec);
        if (!encoding) return tl::unexpected(encoding.error());
        picture.encoding = *encoding;
    }
    for (int c = 0; c < spec.nchannels; ++c) picture.channels.emplace_back(spec.channel_name(c));
    picture.image = {spec.width, spec.height, spec.nchannels, {}};
    picture.image.values.resize(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
    if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.image.values.data()))
        return fail(ErrorCode::File, "{}: cannot be read: {}; write it again", path, reason(*file));
    if (png) decodeSrgb(picture.image, spec.alpha_channel);
    return picture;
}

}  // namespace tyndall

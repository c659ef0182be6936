#include "texture.h"

#include <kit/image/srgb.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "decode_image.h"

namespace tyndall::app {

Result<std::size_t> imageOf(const tinygltf::Model& model, int texture, const std::string& user) {
    if (texture < 0 || static_cast<std::size_t>(texture) >= model.textures.size())
        return fail("{} names texture {}, but the file has {}, counted from 0; correct the index", user, texture,
                    model.textures.size());
    const int source = model.textures[static_cast<std::size_t>(texture)].source;
    if (source < 0) return fail("{}: texture {} has no PNG or JPEG image; export it as one", user, texture);
    return static_cast<std::size_t>(source);
}

Result<Image> readImage(const tinygltf::Model& model, std::size_t source, Encoding encoding, const std::string& user) {
    const tinygltf::Image& kept = model.images[source];
    if (kept.image.empty())
        return fail(ErrorCode::File, "{}: image {} could not be loaded; check that \"{}\" exists", user, source,
                    kept.uri.empty() ? kept.name : kept.uri);
    const auto decoded = decodeImage(kept, source);
    if (!decoded) return passOn(decoded.error(), user);
    const tinygltf::Image& from = *decoded;
    const std::size_t texels = static_cast<std::size_t>(from.width) * static_cast<std::size_t>(from.height);
    const std::size_t channelBytes = from.bits == 16 ? 2 : 1;

    Image image = blankImage(from.width, from.height, 4);
    for (std::size_t i = 0; i < texels; ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            float value;
            if (channelBytes == 2) {
                std::uint16_t stored;
                std::memcpy(&stored, from.image.data() + 2 * (4 * i + c), 2);
                value = static_cast<float>(stored) / 65535.0f;
            } else {
                value = static_cast<float>(from.image[4 * i + c]) / 255.0f;
            }
            image.values[4 * i + c] = encoding == Encoding::Srgb && c < 3 ? linearFromSrgb(value) : value;
        }
    return image;
}

glm::vec4 sampleClamped(const Image& image, double u, double v) {
    const double x = std::clamp(u * image.width - 0.5, 0.0, image.width - 1.0);
    const double y = std::clamp(v * image.height - 0.5, 0.0, image.height - 1.0);
    const auto x0 = static_cast<std::size_t>(x), y0 = static_cast<std::size_t>(y);
    const std::size_t x1 = std::min<std::size_t>(x0 + 1, static_cast<std::size_t>(image.width) - 1);
    const std::size_t y1 = std::min<std::size_t>(y0 + 1, static_cast<std::size_t>(image.height) - 1);
    const auto at = [&](std::size_t column, std::size_t row) { return rgbaOf(image, row * image.width + column); };
    const auto fx = static_cast<float>(x - static_cast<double>(x0)),
               fy = static_cast<float>(y - static_cast<double>(y0));
    return glm::mix(glm::mix(at(x0, y0), at(x1, y0), fx), glm::mix(at(x0, y1), at(x1, y1), fx), fy);
}

}  // namespace tyndall::app

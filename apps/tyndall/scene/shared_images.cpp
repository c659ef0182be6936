#include "shared_images.h"

#include "cone_cookie.h"

namespace tyndall::app {
namespace {

std::size_t append(std::vector<Image>& images, Image image) {
    images.push_back(std::move(image));
    return images.size() - 1;
}

}  // namespace

Result<std::size_t> SharedImages::texture(int texture, Encoding encoding, const std::string& user) {
    const auto source = imageOf(model_, texture, user);
    if (!source) return tl::unexpected(source.error());
    const auto key = std::pair(*source, encoding);
    if (const auto known = textures_.find(key); known != textures_.end()) return known->second;
    auto read = readImage(model_, *source, encoding, user);
    if (!read) return tl::unexpected(read.error());
    return textures_[key] = append(scene_.images, std::move(*read));
}

Result<std::size_t> SharedImages::slide(int texture, const std::string& user) {
    const auto source = imageOf(model_, texture, user);
    if (!source) return tl::unexpected(source.error());
    if (const auto known = slides_.find(*source); known != slides_.end()) return known->second;
    auto read = readImage(model_, *source, Encoding::Srgb, user);
    if (!read) return tl::unexpected(read.error());
    return slides_[*source] = append(scene_.slides, std::move(*read));
}

std::size_t SharedImages::cone(const ConeAngles& cone, std::optional<std::size_t> slide) {
    const ConeKey key{cone.inner, cone.outer, slide};
    if (const auto known = cones_.find(key); known != cones_.end()) return known->second;
    Image baked = bakeCone(cone.inner, cone.outer, slide ? &scene_.slides[*slide] : nullptr);
    return cones_[key] = append(scene_.images, std::move(baked));
}

}  // namespace tyndall::app

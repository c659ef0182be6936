#include "picture.h"

#include <cmath>

namespace tyndall {

BadPixels findBadPixels(const Picture& picture) {
    BadPixels bad;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const glm::vec3& p = picture.pixels[i];
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
        if (bad.count++ == 0) {
            bad.x = static_cast<std::uint32_t>(i % picture.width);
            bad.y = static_cast<std::uint32_t>(i / picture.width);
        }
    }
    return bad;
}

}  // namespace tyndall

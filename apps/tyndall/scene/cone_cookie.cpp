#include "cone_cookie.h"

#include <algorithm>
#include <cmath>

#include "texture.h"

namespace tyndall::app {
namespace {

/// Texels a side without a given cookie. A 90 degree cone with 180 texels would have visible texels of half a degree;
/// here they are a fifth of a degree.
constexpr int smallestSide = 512;
/// Samples a side of each texel, so that the edge of a hard cone is smooth.
constexpr int samples = 4;

/// KHR_lights_punctual, "Inner and Outer Cone Angles".
struct Falloff {
    double dark, scale;

    Falloff(double inner, double outer)
        : dark(std::cos(outer)), scale(1.0 / std::max(0.001, std::cos(inner) - std::cos(outer))) {}
    double operator()(double cosine) const {
        const double share = std::clamp((cosine - dark) * scale, 0.0, 1.0);
        return share * share;
    }
};

}  // namespace

Image bakeCone(double inner, double outer, const Image* given) {
    Image image = blankImage(std::max(smallestSide, given != nullptr ? given->width : 0),
                             std::max(smallestSide, given != nullptr ? given->height : 0), 4);
    const double slope = std::tan(outer);
    const Falloff falloff(inner, outer);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            double sum = 0.0;
            for (int s = 0; s < samples * samples; ++s) {
                const double x = slope * (2.0 * (column + (s % samples + 0.5) / samples) / image.width - 1.0);
                const double y = slope * (2.0 * (row + (s / samples + 0.5) / samples) / image.height - 1.0);
                sum += falloff(1.0 / std::sqrt(1.0 + x * x + y * y));
            }
            const auto cone = static_cast<float>(sum / (samples * samples));
            const glm::vec4 slide =
                given != nullptr ? sampleClamped(*given, (column + 0.5) / image.width, (row + 0.5) / image.height)
                                 : glm::vec4(1.0f);
            setRgba(image, static_cast<std::size_t>(row) * image.width + column,
                    glm::vec4(cone * glm::vec3(slide), 1.0f));
        }
    return image;
}

}  // namespace tyndall::app

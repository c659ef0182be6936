#include <kit/image/image.h>

#include <cmath>

namespace tyndall {

Image blankImage(int width, int height, int channels) {
    return {width, height, channels, std::vector<float>(static_cast<std::size_t>(width) * height * channels)};
}

Image radianceOf(const study::ReferenceImage& reference) {
    Image image = blankImage(reference.width, reference.height, 3);
    for (std::size_t i = 0; i < reference.radiance.size(); ++i)
        for (int c = 0; c < 3; ++c) image.values[3 * i + c] = static_cast<float>(reference.radiance[i][c]);
    return image;
}

std::size_t pixelCount(const Image& image) {
    return static_cast<std::size_t>(image.width) * image.height;
}

glm::vec3 rgbOf(const Image& image, std::size_t pixel) {
    const float* value = &image.values[pixel * image.channels];
    return {value[0], value[1], value[2]};
}

glm::vec4 rgbaOf(const Image& image, std::size_t pixel) {
    const float* value = &image.values[4 * pixel];
    return {value[0], value[1], value[2], value[3]};
}

void setRgba(Image& image, std::size_t pixel, const glm::vec4& value) {
    for (int c = 0; c < 4; ++c) image.values[4 * pixel + c] = value[c];
}

BadPixels findBadPixels(const Image& image) {
    BadPixels bad;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            bool finite = true;
            for (int c = 0; c < image.channels; ++c) finite = finite && std::isfinite(image.at(x, y, c));
            if (finite) continue;
            if (bad.count++ == 0) {
                bad.x = x;
                bad.y = y;
            }
        }
    return bad;
}

}  // namespace tyndall

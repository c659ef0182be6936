#include <study/metrics.h>

#include <cmath>

namespace tyndall::study {

NonFinite countNonFinite(const FloatImage& image) {
    NonFinite found;
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        const float value = image.values[i];
        if (std::isfinite(value)) continue;
        ++(std::isnan(value) ? found.nan : found.infinite);
        if (found.first) continue;
        const std::size_t pixel = i / image.channels;
        found.first = Place{static_cast<int>(pixel % image.width), static_cast<int>(pixel / image.width),
                            static_cast<int>(i % image.channels)};
    }
    return found;
}

}  // namespace tyndall::study

#include "oracle.h"

#include "oracle_fragment.h"
#include "oracle_volume.h"

namespace tyndall::test {
namespace {

void add(Interval& sum, Interval value, Seen seen) {
    // An undecided fragment adds anything from 0 to its value; all contributions are 0 or more.
    sum.hi += std::max(value.hi, 0.0);
    if (seen == Seen::Yes) sum.lo += std::max(value.lo, 0.0);
}

// Each addition in binary32 loses half an ulp of the current total.
void widenByAdding(PixelSum& pixel, const std::array<std::array<double, 4>, 4>& quarterTotals) {
    for (int c = 0; c < 4; ++c) {
        pixel.rgba[c].lo -= kFloatEps * pixel.runningTotals[c];
        pixel.rgba[c].hi += kFloatEps * pixel.runningTotals[c];
        for (int q = 0; q < 4; ++q) {
            pixel.quarter[q][c].lo -= kFloatEps * quarterTotals[q][c];
            pixel.quarter[q][c].hi += kFloatEps * quarterTotals[q][c];
        }
    }
}

}  // namespace

OracleImage oracle(const Shot& shot) {
    OracleImage image{shot.width, shot.height, 0.0, 0.0, {}};
    image.pixels.resize(static_cast<std::size_t>(shot.width) * shot.height);

    const auto volume = lightVolume(shot.light, glm::inverse(shot.eye.worldFromView));
    const auto points = corners(volume);
    const Range range = depthRange(points, shot.eye.nearPlane, std::min(shot.eye.farPlane, shot.farthestSurface));
    if (points.empty() || range.empty()) return image;
    image.nearDepth = range.nearest;
    image.farDepth = range.farthest;

    const double thickness = (range.farthest - range.nearest) / shot.slices;
    const FragmentContext context = fragmentContext(shot, volume, points, thickness);
    for (int y = 0; y < shot.height; ++y)
        for (int x = 0; x < shot.width; ++x) {
            PixelSum& pixel = image.pixels[static_cast<std::size_t>(y) * shot.width + x];
            std::array<std::array<double, 4>, 4> quarterTotals{};
            for (int i = 0; i < shot.slices; ++i) {
                const double depth = range.farthest - (i + 0.5) * thickness;
                const Seen seen = coverage(context, x, y, depth);
                if (seen == Seen::No) continue;
                const auto value = radiance(context, x, y, depth);
                ++pixel.fragments;
                for (int c = 0; c < 4; ++c) {
                    add(pixel.rgba[c], value[c], seen);
                    add(pixel.quarter[i % 4][c], value[c], seen);
                    pixel.runningTotals[c] += pixel.rgba[c].hi;
                    quarterTotals[i % 4][c] += pixel.quarter[i % 4][c].hi;
                    pixel.largest[c] = std::max(pixel.largest[c], value[c].hi);
                }
            }
            widenByAdding(pixel, quarterTotals);
        }
    return image;
}

}  // namespace tyndall::test

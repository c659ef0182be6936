#include "picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tyndall::test {

std::string whyNotFinite(const Picture& picture) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 4; ++c)
                if (!std::isfinite(picture.at(x, y)[c]))
                    return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") channel " + std::to_string(c) +
                           " is not finite";
    return {};
}

std::string whyOutside(const Picture& picture, double scale, const std::vector<Allowed>& allowed) {
    if (const std::string reason = whyNotFinite(picture); !reason.empty()) return reason;
    if (allowed.size() != picture.pixels.size()) return "the picture and what is expected of it differ in size";
    int outside = 0;
    double worst = 0.0;
    std::string examples;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 4; ++c) {
                const double value = static_cast<double>(picture.at(x, y)[c]) / scale;
                const Interval range = allowed[static_cast<std::size_t>(y) * picture.width + x][c];
                if (range.contains(value)) continue;
                const double excess = std::max(range.lo - value, value - range.hi);
                worst = std::max(worst, excess / std::max(std::abs(range.mid()), 1e-30));
                if (++outside > 5) continue;
                char line[160];
                std::snprintf(line, sizeof line, "\n  (%d, %d)[%d] = %.9g, allowed [%.9g, %.9g]", x, y, c, value,
                              range.lo, range.hi);
                examples += line;
            }
    if (outside == 0) return {};
    char head[120];
    std::snprintf(head, sizeof head, "%d values are outside, the worst by %.3g of its middle:", outside, worst);
    return head + examples;
}

std::vector<Allowed> allowedBy(const OracleImage& image) {
    std::vector<Allowed> allowed;
    allowed.reserve(image.pixels.size());
    for (const PixelSum& pixel : image.pixels) allowed.push_back(pixel.rgba);
    return allowed;
}

double vagueness(const std::vector<Allowed>& allowed) {
    double width = 0.0, middle = 0.0;
    for (const Allowed& pixel : allowed)
        for (const Interval& channel : pixel) {
            width += channel.hi - channel.lo;
            middle += channel.mid();
        }
    return middle > 0.0 ? width / middle : 0.0;
}

int litPixels(const Picture& picture) {
    return static_cast<int>(std::count_if(picture.pixels.begin(), picture.pixels.end(), [](const auto& pixel) {
        return pixel[0] > 0.0f || pixel[1] > 0.0f || pixel[2] > 0.0f;
    }));
}

double largestDifference(const Picture& a, const Picture& b) {
    double brightest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            brightest = std::max({brightest, std::abs(static_cast<double>(a.pixels[i][c])),
                                  std::abs(static_cast<double>(b.pixels[i][c]))});
            difference = std::max(difference, std::abs(static_cast<double>(a.pixels[i][c]) - b.pixels[i][c]));
        }
    return brightest > 0.0 ? difference / brightest : 0.0;
}

}  // namespace tyndall::test

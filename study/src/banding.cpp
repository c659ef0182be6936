#include <study/metrics.h>

#include <algorithm>
#include <cmath>

namespace tyndall::study {
namespace {

/// One channel of one row or column.
struct Line {
    const float* image;
    const float* reference;
    std::size_t stride;
    int length;
    double i(int k) const { return image[static_cast<std::size_t>(k) * stride]; }
    double r(int k) const { return reference[static_cast<std::size_t>(k) * stride]; }
};

/// -1, 0 or 1; 0 as well if either is not finite.
int direction(double from, double to) {
    return std::isfinite(to - from) ? (to > from) - (to < from) : 0;
}

/// Whether the run from `first` to `last` is longer than `best`, which it then replaces. The caller sets its start's
/// pixel.
bool improve(Banding& best, const Line& line, int first, int last, double threshold, double dark) {
    if (last - first + 1 <= best.longestRun) return false;
    const double from = line.r(first), to = line.r(last);
    const double change = std::abs(to - from), scale = std::max(std::abs(from), std::abs(to));
    if (!(change > threshold * std::max(scale, dark))) return false;
    best.longestRun = last - first + 1;
    best.change = change;
    best.relativeChange = change / scale;
    return true;
}

/// The first pixel of the line's longest run if it is longer than the best so far; else -1.
int searchLine(Banding& best, const Line& line, double threshold, double dark) {
    int start = -1;
    for (int k = 0; k + 1 < line.length;) {
        // The direction of the reference cannot change within one step. So a change of its direction starts a new run
        // at the same pixel, and a change of the image starts one at the next pixel.
        const int way = direction(line.r(k), line.r(k + 1));
        const int first = k;
        while (k + 1 < line.length && way != 0 && direction(line.r(k), line.r(k + 1)) == way &&
               line.i(k + 1) == line.i(first) && std::isfinite(line.i(first)))
            ++k;
        if (k == first)
            ++k;
        else if (improve(best, line, first, k, threshold, dark))
            start = first;
    }
    return start;
}

}  // namespace

Banding findBanding(const Image& image, const Image& reference, double threshold, double dark) {
    Banding best;
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t rowStride = static_cast<std::size_t>(image.width) * channels;
    const auto search = [&](bool alongRow, int lines, int length) {
        for (int line = 0; line < lines; ++line)
            for (int channel = 0; channel < image.channels; ++channel) {
                const std::size_t start = static_cast<std::size_t>(line) * (alongRow ? rowStride : channels) + channel;
                const int found = searchLine(best,
                                             {image.values.data() + start, reference.values.data() + start,
                                              alongRow ? channels : rowStride, length},
                                             threshold, dark);
                if (found < 0) continue;
                best.alongRow = alongRow;
                best.start = alongRow ? PixelIndex{found, line, channel} : PixelIndex{line, found, channel};
            }
    };
    search(true, image.height, image.width);
    search(false, image.width, image.height);
    return best;
}

}  // namespace tyndall::study

#include "texel_grid.h"

#include <algorithm>
#include <cmath>

namespace tyndall::study {
namespace {

int addressed(double i, int size, Address address) {
    if (address == Address::Clamp) return static_cast<int>(std::clamp(i, 0.0, size - 1.0));
    return static_cast<int>(i - size * std::floor(i / size));
}

void addCrossings(std::vector<double>& places, const ProjectedCoordinate& coordinate, int size, Address address,
                  Span span) {
    const double begin = coordinate.at(span.begin), end = coordinate.at(span.end);
    double first = std::floor(std::min(begin, end)) + 1.0, last = std::ceil(std::max(begin, end)) - 1.0;
    if (address == Address::Clamp) {
        first = std::max(first, 0.0);
        last = std::min(last, size - 1.0);
    }
    for (double k = first; k <= last; k += 1.0)
        if (const double s = coordinate.crossing(k); s > span.begin && s < span.end) places.push_back(s);
}

}  // namespace

TexelPath texelPath(const Image& texture, const Projected& uv) {
    return {scaled(uv.u, texture.width, -0.5), scaled(uv.v, texture.height, -0.5)};
}

void addCrossings(std::vector<double>& places, const TexelPath& path, const Image& texture, Address address,
                  Span span) {
    addCrossings(places, path.x, texture.width, address, span);
    addCrossings(places, path.y, texture.height, address, span);
}

Cell::Cell(const Image& texture, const TexelPath& path, Address address, double s)
    : texture_(&texture), path_(path), left_(std::floor(path.x.at(s))), top_(std::floor(path.y.at(s))) {
    for (int i = 0; i < 2; ++i) {
        x_[i] = addressed(left_ + i, texture.width, address);
        y_[i] = addressed(top_ + i, texture.height, address);
    }
}

bool Cell::uniform(int channels) const {
    for (int c = 0; c < channels; ++c)
        for (int i = 1; i < 4; ++i)
            if (corner(i, c) != corner(0, c)) return false;
    return true;
}

}  // namespace tyndall::study

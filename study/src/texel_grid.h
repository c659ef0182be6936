// Bilinear textures along a ray: the cells between texel centres, in which the texture is a polynomial.
#pragma once

#include <study/image.h>

#include <array>
#include <vector>

#include "light_ray.h"

namespace tyndall::study {

enum class Address { Clamp, Wrap };

/// A texture's coordinates along a ray, in texels; whole numbers are texel centres.
struct TexelPath {
    ProjectedCoordinate x, y;
};

/// `uv` in repeats of the texture; see ProjectedCoordinate.
TexelPath texelPath(const Image& texture, const Projected& uv);

/// Adds every position within `span` where the path crosses a line of texel centres, in no order. A clamped texture is
/// constant beyond its first and last centre, so lines there are left out.
void addCrossings(std::vector<double>& places, const TexelPath& path, const Image& texture, Address address, Span span);

/// One cell of a texture: four texels and the path's place in it. Bilinear as Vulkan defines it ("Texel
/// Filtering"), with weights in full precision.
class Cell {
public:
    /// The cell that holds the path's point at `s`. `texture` must outlive it.
    Cell(const Image& texture, const TexelPath& path, Address address, double s);

    /// Texels at the cell's (left, top), (right, top), (left, bottom), (right, bottom).
    double corner(int i, int channel) const {
        return static_cast<double>(texture_->at(x_[i & 1], y_[i >> 1], channel));
    }
    int column(int i) const { return x_[i & 1]; }
    int row(int i) const { return y_[i >> 1]; }

    /// Weights of the four corners at `s`; `reciprocal`: 1 over the path's denominator there, which all textures of a
    /// light share.
    std::array<double, 4> weights(double s, double reciprocal) const {
        const double fx = (path_.x.n0 + path_.x.n1 * s) * reciprocal - left_;
        const double fy = (path_.y.n0 + path_.y.n1 * s) * reciprocal - top_;
        return {(1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy};
    }
    double blend(const std::array<double, 4>& weight, int channel) const {
        return weight[0] * corner(0, channel) + weight[1] * corner(1, channel) + weight[2] * corner(2, channel) +
               weight[3] * corner(3, channel);
    }

    /// Whether all four texels are equal in the first `channels` channels.
    bool uniform(int channels) const;

private:
    const Image* texture_;
    TexelPath path_;
    double left_, top_;
    std::array<int, 2> x_, y_;
};

}  // namespace tyndall::study

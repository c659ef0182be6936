// Bilinear textures along a ray: the cells between texel centres, in which the texture is a polynomial.
#pragma once

#include <study/texture.h>

#include <array>
#include <vector>

#include "light_ray.h"

namespace tyndall::study {

enum class Address { Clamp, Wrap };

/// A texture's coordinates along a ray, in texels and so that whole numbers are texel centres.
struct TexelPath {
    ProjectedCoordinate x, y;
};

/// `uv` in repeats of the texture; see ProjectedCoordinate.
TexelPath texelPath(const Texture& texture, const Projected& uv);

/// Adds every place within `span` where the path crosses a line of texel centres, in no order. Clamped, lines
/// beyond the first and last centre are left out: nothing changes there.
void addCrossings(std::vector<double>& places, const TexelPath& path, const Texture& texture, Address address,
                  Span span);

/// One cell of a texture: four texels and the path's place in it. Bilinear as Vulkan defines it ("Texel
/// Filtering"), with weights in full precision.
class Cell {
public:
    /// The cell that the path is in at `s`.
    Cell(const Texture& texture, const TexelPath& path, Address address, double s);

    /// Texels at the cell's (left, top), (right, top), (left, bottom), (right, bottom).
    double corner(int i, int channel) const { return texture_->at(x_[i & 1], y_[i >> 1], channel); }
    int column(int i) const { return x_[i & 1]; }
    int row(int i) const { return y_[i >> 1]; }

    /// Weights of the four corners at `s`.
    std::array<double, 4> weights(double s) const;
    double sample(double s, int channel) const;

    /// Whether all four texels are alike in the first `channels` channels.
    bool uniform(int channels) const;

private:
    const Texture* texture_;
    const TexelPath* path_;
    double left_, top_;
    std::array<int, 2> x_, y_;
};

}  // namespace tyndall::study

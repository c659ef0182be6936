// How far a picture is from its reference: the figures, each with its formula.
//
// Below, i is one value (one channel of one pixel) of the image, and r is the same value of the reference. Every mean
// and every sum takes the values that are finite in both pictures. If there is none, Metrics::compared and all figures
// are 0. Terms are doubles. The order of the pixels does not change a sum, not even in its last bit.
#pragma once

#include <study/image.h>
#include <tyndall/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tyndall::study {

/// The place of one value in a picture.
struct PixelIndex {
    int x = 0, y = 0, channel = 0;  ///< from the top left, counted from 0
};

/// The values of a picture that are not finite.
struct NonFinite {
    std::uint64_t nan = 0, infinite = 0;
    std::optional<PixelIndex> first;  ///< in reading order; absent if there is none
    std::uint64_t count() const { return nan + infinite; }
};

/// One pair of values, in the pictures' unit.
struct Sample {
    PixelIndex place;
    double image = 0.0, reference = 0.0;
};

/// Steps in the image where the reference has a gradient. A run is a stretch of pixels in a row or a column of one
/// channel. Along a run the image's values are equal, and the reference strictly rises or strictly falls from pixel to
/// pixel. The run counts if the reference changes over it by more than MetricOptions::bandingThreshold times max(|r|)
/// of the run's two ends, or times Metrics::dark if that is larger: the eye sees no steps in black.
struct Banding {
    int longestRun = 0;           ///< pixels; 0: no run counts
    bool alongRow = true;         ///< false: along a column
    PixelIndex start;             ///< the leftmost or topmost value of the longest run
    double change = 0.0;          ///< of the reference over that run, |r(end) - r(start)|, in the pictures' unit
    double relativeChange = 0.0;  ///< change / max(|r|) of the two ends
};

/// Light that the image lost: i is exactly 0, and r is not.
struct DeadZone {
    std::uint64_t count = 0;  ///< number of such values
    double share = 0.0;       ///< count / Metrics::compared
    Sample largest;           ///< the one with the largest |r|; zeros if there is none
};

struct Metrics {
    int width = 0, height = 0, channels = 0;
    NonFinite image, reference;  ///< of each picture; no figure below includes a pair with such a value
    std::uint64_t compared = 0;  ///< number of pairs that are finite in both

    /// sqrt(sum (i - r)^2 / sum r^2), no unit. If the reference is all zero: 0 if the image is too, otherwise
    /// infinite.
    double relativeL2 = 0.0;
    /// A hundredth of the reference's root mean square, in the pictures' unit. A value below it counts as nearly black.
    double dark = 0.0;
    /// mean of (i - r)^2 / (r^2 + dark^2), no unit. The bright pixels decide relativeL2; here all pixels count that are
    /// not nearly black. It is the relMSE of renderers, with a constant in proportion to the picture's values. If the
    /// reference is all zero: as relativeL2.
    double relativeMeanSquare = 0.0;
    /// max |i - r|, in the pictures' unit.
    double maximumAbsolute = 0.0;
    /// The first place in reading order that has it.
    Sample worst;
    /// mean of (i - r), in the pictures' unit: the energy that the image gains or, below 0, loses.
    double meanDifference = 0.0;
    /// meanDifference / mean of r, no unit. If the mean of r is zero: 0 if meanDifference is too, otherwise infinite
    /// with its sign.
    double energy = 0.0;
    Banding banding;
    DeadZone deadZone;

    bool finite() const { return image.count() == 0 && reference.count() == 0; }
};

struct MetricOptions {
    /// The relative change of the reference above which a run of equal values is a band. Rounding to half floats
    /// changes a value by at most 2^-10 from step to step; 0.001 is just above that.
    double bandingThreshold = 1e-3;
};

NonFinite countNonFinite(const Image& image);

/// Errors, one sentence each: the pictures' widths, heights or numbers of channels differ; a picture has no pixels; its
/// number of values does not fit its size.
Result<Metrics> compare(const Image& image, const Image& reference, const MetricOptions& options = {});

/// The banding measure alone, for an image and a reference of the same size. A value that is not finite ends a run.
Banding findBanding(const Image& image, const Image& reference, double threshold, double dark);

}  // namespace tyndall::study

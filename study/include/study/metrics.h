// How far a picture is from its reference: the figures, each with its formula.
//
// Below, i and r stand for one value (one channel of one pixel) of image and reference. Every mean and sum
// runs over the values that are finite in both; where there is none, all figures are 0 and
// Metrics::compared says so. Terms are doubles, and their sums are the same to the last bit in whatever
// order the pixels come.
#pragma once

#include <study/image.h>
#include <tyndall/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tyndall::study {

/// Where one value of a picture stands.
struct PixelIndex {
    int x = 0, y = 0, channel = 0;  ///< from the top left, counted from 0
};

/// Values of a picture that are no numbers to calculate with.
struct NonFinite {
    std::uint64_t nan = 0, infinite = 0;
    std::optional<PixelIndex> first;  ///< in reading order; absent where there is none
    std::uint64_t count() const { return nan + infinite; }
};

/// One pair of values, in the pictures' own unit.
struct Sample {
    PixelIndex place;
    double image = 0.0, reference = 0.0;
};

/// Steps where the reference has a gradient. Looked for along each row and each column of each channel,
/// wherever the reference strictly rises or strictly falls from pixel to pixel: a run is a stretch of pixels
/// whose image values are equal while the reference moves by more than MetricOptions::bandingThreshold times
/// max(|r|) of the run's two ends, or times `dark` where that is larger: steps in what is black to the eye are
/// none.
struct Banding {
    int longestRun = 0;           ///< pixels; 0: no run moves the reference that far
    bool alongRow = true;         ///< otherwise along a column
    PixelIndex start;             ///< of the longest run: its leftmost or topmost value
    double change = 0.0;          ///< of the reference over that run, |r(end) - r(start)|, in its unit
    double relativeChange = 0.0;  ///< change / max(|r|) of the two ends
};

/// Light that the image lost: i is exactly 0 where r is not.
struct DeadZone {
    std::uint64_t count = 0;  ///< of such values
    double share = 0.0;       ///< count / compared values
    Sample largest;           ///< the one with the largest |r|; without one, zeros
};

struct Metrics {
    int width = 0, height = 0, channels = 0;
    NonFinite image, reference;  ///< counted apart; pairs with such a value are in no figure below
    std::uint64_t compared = 0;  ///< pairs that are finite in both

    /// sqrt(sum (i - r)^2 / sum r^2), no unit. Reference all zero: 0 if the image is too, else infinite.
    double relativeL2 = 0.0;
    /// A hundredth of the reference's root mean square, in the pictures' unit: below it a value counts as
    /// nearly black.
    double dark = 0.0;
    /// mean of (i - r)^2 / (r^2 + dark^2), no unit: where relativeL2 listens to the bright pixels, this listens
    /// to all that are not nearly black. (Renderers' relMSE with a constant that follows the picture's scale.)
    /// Reference all zero: as relativeL2.
    double relativeMeanSquare = 0.0;
    /// max |i - r|, in the pictures' unit, and the first place in reading order that has it.
    double maximumAbsolute = 0.0;
    Sample worst;
    /// mean of (i - r), in the pictures' unit: energy gained or, below 0, lost.
    double meanDifference = 0.0;
    /// meanDifference / mean of r, no unit. Mean of r zero: 0 if meanDifference is too, else infinite with
    /// its sign.
    double energy = 0.0;
    Banding banding;
    DeadZone deadZone;

    bool finite() const { return image.count() == 0 && reference.count() == 0; }
};

struct MetricOptions {
    /// Relative change of the reference over a run of equal values from which it counts as a band. 0.001 lies
    /// just above what rounding to half floats does, at most 2^-10 from step to step.
    double bandingThreshold = 1e-3;
};

NonFinite countNonFinite(const Image& image);

/// Errors, one sentence: pictures whose widths, heights or numbers of channels differ, without pixels, or
/// with another number of values than their size says.
Result<Metrics> compare(const Image& image, const Image& reference,
                                           const MetricOptions& options = {});

/// The banding measure alone; image and reference of one size. Values that are not finite end a run.
Banding findBanding(const Image& image, const Image& reference, double threshold, double dark);

}  // namespace tyndall::study

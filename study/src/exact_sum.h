// A sum of doubles that does not depend on their order.
#pragma once

#include <cstdint>
#include <vector>

namespace tyndall::study {

/// Keeps one pair of integers for each exponent that a double can have, so that adding never rounds. Holds up to 2^36
/// finite values.
class ExactSum {
public:
    void add(double value);
    /// The sum, rounded. Equal sets of values give equal bits. Beyond the range of a double: infinite.
    double value() const;

private:
    /// Values mantissa * 2^exponent with a 53-bit mantissa: upper 27 bits and lower 26, signed.
    struct Digits {
        std::int64_t upper = 0, lower = 0;
    };
    std::vector<Digits> digits_ = std::vector<Digits>(2200);
};

}  // namespace tyndall::study

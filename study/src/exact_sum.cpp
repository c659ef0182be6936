#include "exact_sum.h"

#include <cmath>

namespace tyndall::study {
namespace {

constexpr int lowestExponent = -1074 - 53;  // of the smallest denormal, once its mantissa has 53 bits
constexpr double lowerBits = 1 << 26;

}  // namespace

void ExactSum::add(double value) {
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(value, &exponent), 53);
    if (mantissa == 0.0) return;
    const double upper = std::trunc(mantissa / lowerBits);
    Digits& digits = digits_[static_cast<std::size_t>(exponent - 53 - lowestExponent)];
    digits.upper += static_cast<std::int64_t>(upper);
    digits.lower += static_cast<std::int64_t>(mantissa - upper * lowerBits);
}

double ExactSum::value() const {
    // From the small to the large, each digit an exact integer: the same digits give the same rounding.
    long double sum = 0.0L;
    for (std::size_t i = 0; i < digits_.size(); ++i) {
        if (digits_[i].upper == 0 && digits_[i].lower == 0) continue;
        const int exponent = static_cast<int>(i) + lowestExponent;
        sum += std::ldexp(static_cast<long double>(digits_[i].lower), exponent);
        sum += std::ldexp(static_cast<long double>(digits_[i].upper), exponent + 26);
    }
    return static_cast<double>(sum);
}

}  // namespace tyndall::study

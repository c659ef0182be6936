// One masking term by itself, as it falls on a single slice: what the picture with the term, divided by the
// picture without it, has to be.
#pragma once

#include <tyndall/terms.h>

#include <optional>

#include "oracle.h"

namespace tyndall::test {

/// The shot without that one term.
Shot without(Shot shot, Term term);

/// For each pixel, red, green and blue of the quotient; absent where the slice does not certainly cover the
/// pixel, or where the rest of the picture is dark or not known to 1 %. The shot has the term and one slice, whose
/// depth is the middle of the volume that is seen.
///
/// With the mask m, as the shader rounds it, and everything else f, the pictures are f1 m and f2. The two f
/// need not be the same bits, but both lie in what the oracle allows the picture without the term; so the
/// quotient lies in m times [f.lo / f.hi, f.hi / f.lo].
std::vector<std::optional<std::array<Interval, 3>>> projectedMask(const Shot& shot, Term term);

}  // namespace tyndall::test

// One masking term by itself on a single slice: the expected quotient of the picture with the term and the picture
// without it.
#pragma once

#include <tyndall/terms.h>

#include <optional>

#include "oracle.h"

namespace tyndall::test {

/// The shot without that one term.
Shot without(Shot shot, Term term);

/// For each pixel, red, green and blue of the quotient; absent if the slice may not cover the pixel, or if the rest of
/// the picture is dark or not known to 1 %. The shot has the term and one slice, at the middle depth of the seen
/// volume.
///
/// With the mask m, as the shader rounds it, and everything else f, the pictures are f1 m and f2. f1 and f2 may differ,
/// but both lie in the oracle's interval for the picture without the term. So the quotient lies in m times [f.lo /
/// f.hi, f.hi / f.lo].
std::vector<std::optional<std::array<Interval, 3>>> projectedMask(const Shot& shot, Term term);

}  // namespace tyndall::test

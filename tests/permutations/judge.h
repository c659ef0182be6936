// Verdicts on a permutation's pictures, which leave their evidence in the report.
#pragma once

#include <rig/golden.h>
#include <rig/image.h>

#include <string>

#include "permutation.h"
#include "picture.h"

namespace tyndall::test {

Image imageOf(const Picture& picture);

/// The middle of the allowed interval.
Image imageOf(const std::vector<Allowed>& allowed, int width, int height);

/// If `reason` is empty the comparison has passed, and an earlier run's evidence is removed. Otherwise the running test
/// fails with the technique's name, and its pictures go to the report, with the command that runs this test again. The
/// report is the folder that TYNDALL_REPORT names, or the build folder's `report`. `check` is unique for the
/// permutation. `expected` may be null.
void judge(const Permutation& permutation, const std::string& check, const std::string& reason, const Image& image,
           const Image* expected);

/// Against the golden of that name in tests/permutations/goldens. TYNDALL_UPDATE_GOLDENS=1 makes it again, and fails.
void judgeGolden(const Permutation& permutation, const std::string& name, const Image& image, rig::Tolerance tolerance);

/// Against the oracle's intervals.
void judgeOracle(const Permutation& permutation, const std::string& check, const Picture& picture, double scale,
                 const std::vector<Allowed>& allowed);

}  // namespace tyndall::test

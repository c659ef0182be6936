// Golden images: pictures that a person has looked at and accepted.
#pragma once

#include <rig/compare.h>

#include <optional>
#include <string>

namespace tyndall::rig {

struct GoldenStore {
    std::string folder;
    bool update = false;  ///< writes the given images as goldens; the run still fails
    std::string remedy;   ///< how the user switches `update` on: "set TYNDALL_UPDATE_GOLDENS=1"
};

struct GoldenVerdict {
    std::string reason;             ///< empty if the image equals the golden
    std::optional<Image> expected;  ///< the golden, if there was one
    bool passed() const { return reason.empty(); }
};

/// Compares `image` with `folder`/`name`.exr. A missing golden is a failure. Writing one is also a failure, because
/// a run that makes its own goldens tests nothing. With `update`, a golden that `image` already equals is not
/// rewritten and passes, and an image that is not finite is not written.
GoldenVerdict checkGolden(const GoldenStore& store, const std::string& name, const Image& image, Tolerance tolerance);

}  // namespace tyndall::rig

// Golden images: what a picture was when somebody last looked at it and said yes.
#pragma once

#include <rig/compare.h>

#include <optional>
#include <string>

namespace tyndall::rig {

struct GoldenStore {
    std::string folder;
    bool update = false;  ///< writes what it is shown, and lets the run fail all the same
    std::string remedy;   ///< how the user switches `update` on: "set TYNDALL_UPDATE_GOLDENS=1"
};

struct GoldenVerdict {
    std::string reason;             ///< empty where the image is the golden
    std::optional<Image> expected;  ///< the golden, where there was one
    bool passed() const { return reason.empty(); }
};

/// Holds `image` against `folder`/`name`.exr. A missing golden is a failure; so is having written one, because
/// a run that makes its own truth has tested nothing. With `update`, a golden that is met already is left alone
/// and passes, and an image that is not finite is not written.
GoldenVerdict checkGolden(const GoldenStore& store, const std::string& name, const Image& image, Tolerance tolerance);

}  // namespace tyndall::rig

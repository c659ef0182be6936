// All checks of one technique.
#pragma once

#include <rig/golden.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "effect_renderer.h"

namespace tyndall::rig {

struct CheckResult {
    std::string pass;    ///< empty: the technique as a whole
    std::string check;   ///< "finite", "golden", "liveness of RippleSampler"
    std::string reason;  ///< empty: passed
    std::optional<Image> image, expected;
};

struct TechniqueResult {
    std::vector<CheckResult> checks;
    std::vector<std::string> notes;  ///< not failures
    bool passed() const;
};

/// Checks after each pass: drawing gives no validation messages, every value is finite, specialized and frozen
/// modules agree bit for bit, two runs agree bit for bit, and with `goldens` the picture equals the golden. After all
/// passes: resources that are not live change nothing.
TechniqueResult checkTechnique(headless::Device& device, EffectRenderer& renderer, const permgen::Effect& effect,
                               const permgen::Technique& technique, Tolerance tolerance, const GoldenStore* goldens);

/// A pass's name in messages and files: its own, or its number if it has no name or shares it.
std::string passLabel(const permgen::Technique& technique, std::size_t pass);

/// The golden's name: the technique, and the pass if there are several.
std::string goldenName(const permgen::Technique& technique, std::size_t pass);

}  // namespace tyndall::rig

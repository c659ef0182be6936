// Everything that is demanded of one technique.
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
    std::vector<std::string> notes;  ///< worth knowing, and no failure
    bool passed() const;
};

/// After each pass: it can be drawn without a word from validation, every value is finite, specialized and frozen
/// modules agree bit for bit, and so do two runs; with `goldens`, it is the golden. After all: what is not live
/// changes nothing, whatever is bound there.
TechniqueResult checkTechnique(headless::Device& device, EffectRenderer& renderer, const permgen::Effect& effect,
                               const permgen::Technique& technique, Tolerance tolerance, const GoldenStore* goldens);

/// What a pass is called in messages and files: its name, or its place where it has none or not one of its own.
std::string passLabel(const permgen::Technique& technique, std::size_t pass);

/// The golden's name: the technique, and the pass where there are several.
std::string goldenName(const permgen::Technique& technique, std::size_t pass);

}  // namespace tyndall::rig

#include "checks.h"

#include <fmt/format.h>

#include <algorithm>

namespace tyndall::rig {
namespace {

class TechniqueCheck {
public:
    TechniqueCheck(headless::Device& device, EffectRenderer& renderer, const permgen::Effect& effect,
                   const permgen::Technique& technique, Tolerance tolerance, const GoldenStore* goldens)
        : device_(device),
          renderer_(renderer),
          effect_(effect),
          technique_(technique),
          tolerance_(tolerance),
          goldens_(goldens) {}

    TechniqueResult run() {
        bool drawn = true;
        for (std::size_t pass = 0; pass < technique_.passes.size() && drawn; ++pass) drawn = checkPass(pass);
        if (drawn) checkLiveness();
        return std::move(result_);
    }

private:
    /// The picture, if it can be drawn without validation messages; else records the failure.
    std::optional<Image> draw(const std::string& pass, std::size_t passes, Shaders shaders, Variation variation = {}) {
        device_.clearMessages();
        auto image = renderer_.draw(technique_, passes, shaders, variation);
        std::string reason = image ? std::string() : image.error().message;
        for (const std::string& message : device_.messages()) reason += (reason.empty() ? "" : "; ") + message;
        const std::string kind = shaders == Shaders::Frozen ? "frozen" : "specialized";
        if (!variation.empty()) {
            if (!reason.empty()) add({pass, fmt::format("drawn with another {}", variation), reason, {}, {}});
        } else {
            add({pass, "drawn, " + kind, reason, {}, {}});
        }
        if (!reason.empty()) return std::nullopt;
        return std::move(*image);
    }

    bool checkPass(std::size_t pass) {
        const std::string label = passLabel(technique_, pass);
        auto frozen = draw(label, pass + 1, Shaders::Frozen);
        if (!frozen) return false;
        const std::string reason = whyNotFinite(*frozen);
        add({label, "finite", reason, *frozen, {}});
        if (!reason.empty()) return true;
        if (auto specialized = draw(label, pass + 1, Shaders::Specialized))
            compare(label, "specialized against frozen", std::move(*specialized), *frozen);
        if (auto again = draw(label, pass + 1, Shaders::Frozen))
            compare(label, "run against run", std::move(*again), *frozen);
        if (goldens_) {
            GoldenVerdict verdict = checkGolden(*goldens_, goldenName(technique_, pass), *frozen, tolerance_);
            add({label, "golden", verdict.reason, std::move(*frozen), std::move(verdict.expected)});
        }
        return true;
    }

    void compare(const std::string& pass, const std::string& check, Image image, const Image& expected) {
        const std::string reason = whyDifferent(image, expected, Tolerance::Exact);
        add({pass, check, reason, std::move(image), expected});
    }

    void checkLiveness() {
        const auto usual = draw({}, technique_.passes.size(), Shaders::Specialized);
        if (!usual) return;
        for (const permgen::Resource& resource : effect_.resources) {
            if (!renderer_.canVary(resource.name)) continue;
            auto varied = draw({}, technique_.passes.size(), Shaders::Specialized, resource.name);
            if (!varied) continue;
            const bool live = std::any_of(technique_.passes.begin(), technique_.passes.end(),
                                          [&](const auto& pass) { return permgen::is_live(pass, resource.name); });
            const Difference apart = difference(*varied, *usual);
            std::string reason;
            if (!live && apart.differing > 0)
                reason = fmt::format(
                    "{0} is not live, but another {0} changes {1} values, the largest change at pixel ({2}, {3}); "
                    "compile the effect again, and report this if it stays",
                    resource.name, apart.differing, apart.at.x, apart.at.y);
            if (live && apart.differing == 0)
                result_.notes.push_back(
                    fmt::format("{} is live, but changing it changes no value; choose a fixture that shows its effect",
                                resource.name));
            add({{}, fmt::format("liveness of {}", resource.name), reason, std::move(*varied), *usual});
        }
    }

    void add(CheckResult check) {
        if (check.reason.empty()) check.image.reset(), check.expected.reset();
        result_.checks.push_back(std::move(check));
    }

    headless::Device& device_;
    EffectRenderer& renderer_;
    const permgen::Effect& effect_;
    const permgen::Technique& technique_;
    Tolerance tolerance_;
    const GoldenStore* goldens_;
    TechniqueResult result_;
};

}  // namespace

bool TechniqueResult::passed() const {
    return std::all_of(checks.begin(), checks.end(), [](const CheckResult& check) { return check.reason.empty(); });
}

TechniqueResult checkTechnique(headless::Device& device, EffectRenderer& renderer, const permgen::Effect& effect,
                               const permgen::Technique& technique, Tolerance tolerance, const GoldenStore* goldens) {
    return TechniqueCheck(device, renderer, effect, technique, tolerance, goldens).run();
}

std::string passLabel(const permgen::Technique& technique, std::size_t pass) {
    const std::string name(technique.passes[pass].name);
    const auto same = std::count_if(technique.passes.begin(), technique.passes.end(),
                                    [&](const permgen::Pass& other) { return other.name == name; });
    return name.empty() || same > 1 ? fmt::format("{}{}", name.empty() ? "pass" : name, pass) : name;
}

std::string goldenName(const permgen::Technique& technique, std::size_t pass) {
    std::string name(technique.name);
    if (technique.passes.size() > 1) name += "." + passLabel(technique, pass);
    return name;
}

}  // namespace tyndall::rig

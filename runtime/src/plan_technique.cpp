#include "plan_technique.h"

#include <tyndall/plan.h>

#include <array>
#include <vector>

namespace tyndall {
namespace {

// By number: bit 2 noise, bit 1 shadow, bit 0 cookie.
constexpr std::array<std::string_view, 8> names = {
    "clip_nonoise_noshadow_nocookie_technique", "clip_nonoise_noshadow_cookie_technique",
    "clip_nonoise_shadow_nocookie_technique",   "clip_nonoise_shadow_cookie_technique",
    "clip_noise_noshadow_nocookie_technique",   "clip_noise_noshadow_cookie_technique",
    "clip_noise_shadow_nocookie_technique",     "clip_noise_shadow_cookie_technique",
};

// "noise", "noise and shadow", "noise, shadow and cookie"
std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
        text += words[i];
    }
    return text;
}

}  // namespace

Terms termsOf(const Light& light) {
    return {light.noise.has_value(), light.shadow, light.cookie};
}

std::optional<Terms> termsOf(std::string_view techniqueName) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == techniqueName) return Terms{(i & 4) != 0, (i & 2) != 0, (i & 1) != 0};
    return std::nullopt;
}

std::string_view techniqueName(bool noise, bool shadow, bool cookie) {
    return names[(noise ? 4u : 0u) | (shadow ? 2u : 0u) | (cookie ? 1u : 0u)];
}

std::string_view techniqueName(const Terms& terms) {
    return techniqueName(terms.noise, terms.shadow, terms.cookie);
}

std::string techniqueReason(const Terms& calledFor, const Terms& drawn, bool forced) {
    if (forced && drawn == calledFor) return "The options ask for this technique, as does the light itself.";
    if (forced)
        return "The options ask for this technique; the light by itself calls for " +
               std::string(techniqueName(calledFor)) + ".";
    std::vector<std::string> wanted, spared;
    (drawn.noise ? wanted : spared).push_back("noise");
    (drawn.shadow ? wanted : spared).push_back("shadow");
    (drawn.cookie ? wanted : spared).push_back("cookie");
    if (wanted.empty()) return "The light calls for none of " + listed(spared) + ".";
    if (spared.empty()) return "The light calls for " + listed(wanted) + ".";
    return "The light calls for " + listed(wanted) + ", and not for " + listed(spared) + ".";
}

}  // namespace tyndall

#include "needs/plan_technique.h"

#include <tyndall/plan.h>

#include <array>

namespace tyndall {
namespace {

// By number: bit 2 noise, bit 1 shadow, bit 0 cookie.
constexpr std::array<std::string_view, 8> names = {
    "clip_nonoise_noshadow_nocookie_technique", "clip_nonoise_noshadow_cookie_technique",
    "clip_nonoise_shadow_nocookie_technique",   "clip_nonoise_shadow_cookie_technique",
    "clip_noise_noshadow_nocookie_technique",   "clip_noise_noshadow_cookie_technique",
    "clip_noise_shadow_nocookie_technique",     "clip_noise_shadow_cookie_technique",
};

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

}  // namespace tyndall

// Which technique of slices.fx a light is drawn with, and why.
#pragma once

#include <tyndall/light.h>

#include <optional>
#include <string_view>

namespace tyndall {

/// The switches of ps_main.
struct Terms {
    bool noise = false, shadow = false, cookie = false;
    friend bool operator==(const Terms&, const Terms&) = default;
};

Terms termsOf(const Light& light);

/// The terms of the technique of that name, if slices.fx has it.
std::optional<Terms> termsOf(std::string_view techniqueName);

std::string_view techniqueName(const Terms& terms);

}  // namespace tyndall

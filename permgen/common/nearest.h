// "Did you mean ...?"
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace permgen {

/// The candidate with the fewest typing errors to `name` (wrong, missing, extra or swapped letters; letter case counts
/// little), or nothing if none is close.
std::string_view nearest(std::string_view name, std::span<const std::string_view> candidates);

/// `before` + the nearest candidate + `after`, or nothing.
std::string suggestion(std::string_view name, std::span<const std::string_view> candidates, std::string_view before,
                       std::string_view after);

}  // namespace permgen

// The error when a container of fixed capacity would overflow. Every capacity here has a proof, so this is a fault of
// the library. It is never hidden: the stage throws, and Planner::plan() returns an Error.
#pragma once

#include <tyndall/result.h>

#include <cstddef>
#include <source_location>
#include <stdexcept>

namespace tyndall {

struct CapacityExceeded : std::length_error {
    using std::length_error::length_error;
};

/// Throws CapacityExceeded. The message names the function that adds the entry, and the capacity.
[[noreturn]] void throwCapacityExceeded(std::size_t capacity, const std::source_location& where);

/// The Error that the library's caller gets.
Error internalError(const CapacityExceeded& exceeded);

}  // namespace tyndall

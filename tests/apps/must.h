// Unwraps results that a test needs.
#pragma once

#include <kit/fail.h>

#include <stdexcept>
#include <utility>

namespace tyndall::test {

/// Throws std::runtime_error with the error's message.
template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

}  // namespace tyndall::test

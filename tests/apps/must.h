// For what a test cannot go on without.
#pragma once

#include <kit/fail.h>

#include <stdexcept>
#include <utility>

namespace tyndall::test {

/// Errors: std::runtime_error with what the outcome says.
template <class T>
T must(Result<T> outcome) {
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return std::move(*outcome);
}

}  // namespace tyndall::test

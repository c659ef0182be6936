// For what a test cannot go on without.
#pragma once

#include <tyndall/outcome.h>

#include <stdexcept>
#include <utility>

namespace tyndall::test {

/// Errors: std::runtime_error with what the outcome says.
template <class T>
T must(app::Outcome<T> outcome) {
    if (!outcome) throw std::runtime_error(outcome.error());
    return std::move(*outcome);
}

}  // namespace tyndall::test

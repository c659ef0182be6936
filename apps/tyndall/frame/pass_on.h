// Errors of the libraries below as this program's sentences.
#pragma once

#include <tyndall/result.h>

#include <utility>

#include <kit/fail.h>

namespace tyndall::app {

/// The value, or the error with `what` before it.
template <class T>
Result<T> passOn(Result<T> result, const char* what) {
    if (result) return std::move(*result);
    return fail("{}: {}", what, result.error().message);
}

inline Result<void> passOn(const Result<void>& result, const char* what) {
    if (result) return {};
    return fail("{}: {}", what, result.error().message);
}

}  // namespace tyndall::app

// Turns errors of the libraries into this program's messages.
#pragma once

#include <tyndall/result.h>

#include <string>
#include <utility>

namespace tyndall::app {

/// The value, or the error with `what` before its sentence. Its code and the API's result stay.
template <class T>
Result<T> passOn(Result<T> result, const char* what) {
    return std::move(result).map_error([what](Error error) {
        error.message = std::string(what) + ": " + error.message;
        return error;
    });
}

}  // namespace tyndall::app

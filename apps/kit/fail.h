// Errors of the programs' own parts: one sentence for the user at the terminal.
#pragma once

#include <fmt/format.h>
#include <tyndall/result.h>

#include <string>
#include <utility>

namespace tyndall {

/// `sentence` without a trailing newline names place, rule and remedy.
inline tl::unexpected<Error> failWith(std::string sentence) {
    return tl::unexpected(Error{ErrorCode::InvalidArgument, std::move(sentence)});
}

/// One sentence without a trailing newline that names place, rule and remedy.
template <class... Args>
tl::unexpected<Error> fail(fmt::format_string<Args...> text, Args&&... args) {
    return failWith(fmt::format(text, std::forward<Args>(args)...));
}

/// The same with another code than InvalidArgument.
template <class... Args>
tl::unexpected<Error> fail(ErrorCode code, fmt::format_string<Args...> text, Args&&... args) {
    return tl::unexpected(Error{code, fmt::format(text, std::forward<Args>(args)...)});
}

/// The error with `what` before its sentence. Its code and the API's own result stay.
inline tl::unexpected<Error> passOn(Error error, const std::string& what) {
    error.message = what + ": " + error.message;
    return tl::unexpected(std::move(error));
}

/// The value, or the error as above.
template <class T>
Result<T> passOn(Result<T> result, const std::string& what) {
    if (result) return result;
    return passOn(std::move(result).error(), what);
}

}  // namespace tyndall

// How the programs' own parts fail: with one sentence, meant for the person at the terminal.
#pragma once

#include <fmt/format.h>
#include <tyndall/result.h>

#include <utility>

namespace tyndall {

/// One sentence without a trailing newline that names place, rule and remedy.
template <class... Args>
tl::unexpected<Error> fail(fmt::format_string<Args...> text, Args&&... args) {
    return tl::unexpected(Error{ErrorCode::InvalidArgument, fmt::format(text, std::forward<Args>(args)...)});
}

}  // namespace tyndall

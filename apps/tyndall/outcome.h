// How the program's own parts fail: with one sentence, meant for the person at the terminal.
#pragma once

#include <fmt/format.h>

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace tyndall::app {

/// A value, or one sentence without a trailing newline that names place, rule and remedy.
template <class T>
using Outcome = tl::expected<T, std::string>;

template <class... Args>
tl::unexpected<std::string> fail(fmt::format_string<Args...> text, Args&&... args) {
    return tl::unexpected<std::string>(fmt::format(text, std::forward<Args>(args)...));
}

}  // namespace tyndall::app

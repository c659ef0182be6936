// How the rig says that something went wrong: a value or one sentence that names place, rule and remedy.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace tyndall::rig {

template <class T>
using Outcome = tl::expected<T, std::string>;

}  // namespace tyndall::rig

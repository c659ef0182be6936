// JSON as the program writes it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tyndall::app {

/// Indented, with a newline at the end. Names that are no UTF-8, as file systems allow, get U+FFFD in place of
/// what is none.
inline std::string jsonText(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace tyndall::app

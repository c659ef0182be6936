// JSON as the program writes it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tyndall::app {

/// Indented, with a newline at the end. Bytes that are not UTF-8, as file systems allow them, become U+FFFD.
inline std::string jsonText(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace tyndall::app

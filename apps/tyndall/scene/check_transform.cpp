#include "check_transform.h"

#include <algorithm>

namespace tyndall::app {
namespace {

using nlohmann::json;

Result<void> checkNumbers(const json& node, const char* key, std::size_t size, const std::string& place) {
    const auto found = node.find(key);
    if (found == node.end()) return {};
    const bool numbers =
        found->is_array() && std::ranges::all_of(*found, [](const json& value) { return value.is_number(); });
    if (numbers && found->size() == size) return {};
    return fail("{}.{} must be {} numbers, but is {}; export the file again", place, key, size,
                numbers ? fmt::format("{}", found->size()) : std::string("something else"));
}

}  // namespace

Result<void> checkTransform(const json& node, const std::string& place) {
    for (const auto& [key, size] :
         {std::pair("translation", 3), std::pair("rotation", 4), std::pair("scale", 3), std::pair("matrix", 16)})
        if (auto checked = checkNumbers(node, key, static_cast<std::size_t>(size), place); !checked) return checked;
    const auto rotation = node.find("rotation");
    if (rotation != node.end() &&
        std::ranges::all_of(*rotation, [](const json& value) { return value.get<double>() == 0.0; }))
        return fail("{}.rotation is all zeros, which is not a rotation; write 0, 0, 0, 1 for none", place);
    return {};
}

}  // namespace tyndall::app

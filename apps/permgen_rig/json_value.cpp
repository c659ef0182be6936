#include "json_value.h"

#include <common/nearest.h>

#include <algorithm>

namespace tyndall::rig {

std::string JsonValue::below(std::string_view name) const {
    return fmt::format("{}{}{}", place_, place_.ends_with(':') ? ' ' : '.', name);
}

std::string JsonValue::text() const {
    if (!json_->is_string()) fail("this must be a text in quotes, not {}", json_->dump());
    return json_->get<std::string>();
}

bool JsonValue::boolean() const {
    if (!json_->is_boolean()) fail("this must be true or false, not {}", json_->dump());
    return json_->get<bool>();
}

double JsonValue::number(double minimum, double maximum) const {
    if (!json_->is_number()) fail("this must be a number, not {}", json_->dump());
    const double value = json_->get<double>();
    if (!(value >= minimum && value <= maximum))
        fail("this must be a number from {} to {}, not {}", minimum, maximum, json_->dump());
    return value;
}

int JsonValue::integer(int minimum, int maximum) const {
    const double value = json_->is_number() ? json_->get<double>() : minimum - 1.0;
    if (!(value >= minimum && value <= maximum) || value != static_cast<int>(value))
        fail("this must be a whole number from {} to {}, not {}", minimum, maximum, json_->dump());
    return static_cast<int>(value);
}

std::vector<JsonValue> JsonValue::list() const {
    if (!json_->is_array()) fail("this must be a list in brackets, not {}", json_->dump());
    std::vector<JsonValue> values;
    for (std::size_t i = 0; i < json_->size(); ++i) values.emplace_back((*json_)[i], fmt::format("{}[{}]", place_, i));
    return values;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
    if (!json_->is_object()) fail("this must be an object in braces, not {}", json_->dump());
    std::vector<std::pair<std::string, JsonValue>> all;
    for (const auto& [name, value] : json_->items()) all.emplace_back(name, JsonValue(value, below(name)));
    return all;
}

bool JsonValue::has(std::string_view name) const {
    return json_->is_object() && json_->contains(name);
}

JsonValue JsonValue::at(std::string_view name) const {
    if (!has(name)) fail("\"{}\" is missing", name);
    return {json_->at(std::string(name)), below(name)};
}

void JsonValue::allowOnly(std::initializer_list<std::string_view> names) const {
    for (const auto& [name, value] : members()) {
        if (std::find(names.begin(), names.end(), name) != names.end()) continue;
        const std::vector<std::string_view> known(names);
        fail("\"{}\" has no meaning here{}; it may hold {}", name,
             permgen::suggestion(name, known, "; did you mean \"", "\"?"), fmt::join(known, ", "));
    }
}

}  // namespace tyndall::rig

// A JSON value with its place in the file, for error messages.
#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tyndall::rig {

/// Thrown while a fixture is read, caught by readFixture().
struct FixtureFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class JsonValue {
public:
    using Json = nlohmann::ordered_json;

    /// `json` must outlive it. The root's place ends with a colon: "toon.json:".
    JsonValue(const Json& json, std::string place) : json_(&json), place_(std::move(place)) {}

    template <class... Args>
    [[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) const {
        throw FixtureFault(place_ + (place_.ends_with(':') ? " " : ": ") +
                           fmt::format(text, std::forward<Args>(args)...));
    }

    const Json& json() const { return *json_; }
    std::string text() const;
    bool boolean() const;
    /// Finite, and within the bounds.
    double number(double minimum = -3.4e38, double maximum = 3.4e38) const;
    int integer(int minimum, int maximum) const;
    std::vector<JsonValue> list() const;
    std::vector<std::pair<std::string, JsonValue>> members() const;
    bool has(std::string_view name) const;
    JsonValue at(std::string_view name) const;
    /// Fails on a member of another name, with the nearest of these.
    void allowOnly(std::initializer_list<std::string_view> names) const;

private:
    std::string below(std::string_view name) const;

    const Json* json_;
    std::string place_;
};

}  // namespace tyndall::rig

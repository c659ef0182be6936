// A value in the manifest together with its place, for error messages.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace permgen {

/// A word of the manifest and its value.
template <class Value>
struct NamedValue {
    std::string_view name;
    Value value;
};

class JsonNode {
public:
    /// `json` must outlive this. `place` is empty for the whole manifest.
    JsonNode(const nlohmann::json& json, std::string file, std::string place = {})
        : json_(&json), file_(std::move(file)), place_(std::move(place)) {}

    /// Each throws a Fault if the field is absent or the value has another type.
    JsonNode operator[](std::string_view field) const;
    std::vector<JsonNode> items() const;
    std::string text() const;
    std::uint32_t number() const;
    bool truth() const;

    bool has(std::string_view field) const;
    bool is_null() const { return json_->is_null(); }

    /// The value of a text that must be one of `words`.
    template <class Words>
    auto word(const Words& words) const {
        const std::string written = text();
        std::string known;
        for (const auto& candidate : words) {
            if (candidate.name == written) return candidate.value;
            known += (known.empty() ? "" : ", ") + std::string(candidate.name);
        }
        fail("'" + written + "' is not one of " + known);
    }

    /// Throws a Fault: "FILE: PLACE: WHAT; " and the remedy.
    [[noreturn]] void fail(const std::string& what) const;

private:
    const nlohmann::json* json_;
    std::string file_, place_;
};

}  // namespace permgen

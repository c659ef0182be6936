// Reading the values of Direct3D 9 states: small tables of words.
#pragma once

#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string_view>

namespace tyndall {

inline bool sameWord(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::toupper(static_cast<unsigned char>(a[i])) != std::toupper(static_cast<unsigned char>(b[i])))
            return false;
    return true;
}

template <class Value>
struct Word {
    std::string_view name;
    Value value;
};

template <class Value, std::size_t N>
std::optional<Value> lookUp(const std::array<Word<Value>, N>& words, std::string_view name) {
    for (const Word<Value>& word : words)
        if (sameWord(word.name, name)) return word.value;
    return std::nullopt;
}

inline std::optional<bool> readBool(std::string_view value) {
    if (sameWord(value, "TRUE") || value == "1") return true;
    if (sameWord(value, "FALSE") || value == "0") return false;
    return std::nullopt;
}

}  // namespace tyndall

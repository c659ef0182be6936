#include "emit/namespace_name.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace permgen {
namespace {

// C++20, [lex.key] and [lex.digraph], and the two namespaces that the header uses.
constexpr std::string_view taken[] = {"alignas",   "alignof",      "and",           "and_eq",
                                      "asm",       "auto",         "bitand",        "bitor",
                                      "bool",      "break",        "case",          "catch",
                                      "char",      "char16_t",     "char32_t",      "char8_t",
                                      "class",     "co_await",     "co_return",     "co_yield",
                                      "compl",     "concept",      "const",         "const_cast",
                                      "consteval", "constexpr",    "constinit",     "continue",
                                      "decltype",  "default",      "delete",        "do",
                                      "double",    "dynamic_cast", "else",          "enum",
                                      "explicit",  "export",       "extern",        "false",
                                      "float",     "for",          "friend",        "goto",
                                      "if",        "inline",       "int",           "long",
                                      "mutable",   "namespace",    "new",           "noexcept",
                                      "not",       "not_eq",       "nullptr",       "operator",
                                      "or",        "or_eq",        "permgen",       "private",
                                      "protected", "public",       "register",      "reinterpret_cast",
                                      "requires",  "return",       "short",         "signed",
                                      "sizeof",    "static",       "static_assert", "static_cast",
                                      "std",       "struct",       "switch",        "template",
                                      "this",      "thread_local", "throw",         "true",
                                      "try",       "typedef",      "typeid",        "typename",
                                      "union",     "unsigned",     "using",         "virtual",
                                      "void",      "volatile",     "wchar_t",       "while",
                                      "xor",       "xor_eq"};

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// An identifier that is allowed at global scope ([lex.name]: no leading or double underscore).
bool is_part(std::string_view part) {
    if (part.empty() || !is_letter(part.front()) || is_keyword(part)) return false;
    if (part.find("__") != std::string_view::npos) return false;
    return std::all_of(part.begin(), part.end(), [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

}  // namespace

bool is_keyword(std::string_view word) {
    return std::find(std::begin(taken), std::end(taken), word) != std::end(taken);
}

bool is_namespace(const std::string& name) {
    std::string_view rest = name;
    for (;;) {
        const std::size_t colons = rest.find("::");
        if (!is_part(rest.substr(0, colons))) return false;
        if (colons == std::string_view::npos) return true;
        rest.remove_prefix(colons + 2);
    }
}

std::string default_namespace(const std::string& effect) {
    std::string name;
    for (const char c : effect) {
        const char next = is_letter(c) || is_digit(c) ? c : '_';
        if (next != '_' || (!name.empty() && name.back() != '_')) name += next;
    }
    if (!name.empty() && name.back() == '_') name.pop_back();
    if (name.empty()) return "effect";
    if (is_digit(name.front())) name = "effect_" + name;
    if (is_keyword(name)) name += "_effect";
    return name;
}

}  // namespace permgen

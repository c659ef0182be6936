#include "front/diagnostic.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

namespace permgen {

namespace {

constexpr std::size_t max_shown_bytes = 400;  // a longer line only fills the terminal

/// The line without its end. Lines end as in make_source(): "\n", "\r\n" or "\r".
std::optional<std::string> read_line(const SourceLocation& place) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(place.file, error)) return std::nullopt;
    std::ifstream file(place.file, std::ios::binary);
    std::string line;
    int number = 1;
    for (char c = 0; number <= place.line && file.get(c);) {
        const bool ends = c == '\n' || c == '\r';
        if (ends) {
            if (c == '\r' && file.peek() == '\n') file.get(c);
            ++number;
        } else if (number == place.line) {
            line += c;
        }
    }
    if (number < place.line) return std::nullopt;
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (place.line == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    return line;
}

/// The line and a caret under the column; empty if the file has no such place (a #line may name any).
std::string shown_line(const SourceLocation& place) {
    if (place.file.empty() || place.line <= 0 || place.column <= 0) return {};
    const std::optional<std::string> line = read_line(place);
    const auto column = static_cast<std::size_t>(place.column) - 1;
    if (!line || column > line->size() || line->size() > max_shown_bytes) return {};
    std::string below;
    for (std::size_t i = 0; i < column; ++i) {
        const bool continues = (static_cast<unsigned char>((*line)[i]) & 0xc0) == 0x80;  // within a UTF-8 character
        if (!continues) below += (*line)[i] == '\t' ? '\t' : ' ';
    }
    return '\n' + *line + '\n' + below + '^';
}

}  // namespace

std::string format(const Diagnostic& diagnostic) {
    static constexpr const char* severities[] = {"error", "warning", "note"};
    std::string text;
    if (!diagnostic.place.file.empty()) {
        text += diagnostic.place.file;
        if (diagnostic.place.line > 0) {
            text += ':' + std::to_string(diagnostic.place.line);
            if (diagnostic.place.column > 0) text += ':' + std::to_string(diagnostic.place.column);
        }
        text += ": ";
    }
    text += severities[static_cast<int>(diagnostic.severity)];
    text += '[' + diagnostic.code + "]: " + diagnostic.message;
    return text + shown_line(diagnostic.place);
}

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Error; });
}

}  // namespace permgen

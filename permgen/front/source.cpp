#include "front/source.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace permgen {

std::int32_t Sources::name_index(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::int32_t>(found - names.begin());
    names.emplace_back(name);
    return static_cast<std::int32_t>(names.size() - 1);
}

std::string_view Sources::keep(std::string spelling) {
    spellings.push_back(std::move(spelling));
    return spellings.back();
}

SourceLocation Sources::place(Location location) const {
    SourceLocation place;
    if (location.file >= 0) place.file = names[static_cast<std::size_t>(location.file)];
    place.line = location.line;
    place.column = location.column;
    return place;
}

std::optional<std::string> read_bytes(const std::string& path, std::string& reason) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        reason = "it does not exist";
        return std::nullopt;
    }
    if (!std::filesystem::is_regular_file(status)) {
        reason = "it is not a regular file";
        return std::nullopt;
    }
    if (std::filesystem::file_size(path, error) > max_source_bytes || error) {
        reason = "it is larger than 16 MiB";
        return std::nullopt;
    }
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream bytes;
    if (stream && stream.peek() != std::ifstream::traits_type::eof()) bytes << stream.rdbuf();
    if (!stream && !stream.eof()) {
        reason = "it cannot be read; check its permissions";
        return std::nullopt;
    }
    return std::move(bytes).str();
}

SourceFile make_source(std::string path, std::string_view bytes) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    SourceFile source;
    source.path = std::move(path);
    source.text.reserve(bytes.size() + 1);
    source.runs.push_back({});

    std::int32_t line = 1;
    std::size_t i = bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    const auto newline_length = [&](std::size_t at) -> std::size_t {
        if (at >= bytes.size()) return 0;
        if (bytes[at] == '\n') return 1;
        if (bytes[at] == '\r') return at + 1 < bytes.size() && bytes[at + 1] == '\n' ? 2 : 1;
        return 0;
    };
    const auto next_line = [&](std::size_t length) {
        i += length;
        ++line;
        source.runs.push_back({source.text.size(), line, 1});
    };
    while (i < bytes.size()) {
        if (const std::size_t length = newline_length(i)) {
            source.text.push_back('\n');
            next_line(length);
        } else if (const std::size_t joined = bytes[i] == '\\' ? newline_length(i + 1) : 0) {
            next_line(1 + joined);
        } else {
            source.text.push_back(bytes[i++]);
        }
    }
    if (source.text.empty() || source.text.back() != '\n') source.text.push_back('\n');
    return source;
}

}  // namespace permgen

// The author's files, and the map from any character to its line and column.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "front/diagnostic.h"

namespace permgen {

/// A SourceLocation in compact form, since every token has one. `file` indexes Sources::names.
struct Location {
    std::int32_t file = -1;
    std::int32_t line = 0;
    std::int32_t column = 0;
};

/// The position of a run of consecutive characters of SourceFile::text in the author's file.
struct SourceRun {
    std::size_t offset = 0;
    std::int32_t line = 1;
    std::int32_t column = 1;
};

/// One file, prepared for the lexer: no byte order mark, every line ends in a single '\n', and lines that end in a
/// backslash are joined with the next.
struct SourceFile {
    std::string path;
    std::string text;
    std::vector<SourceRun> runs;  ///< ascending offsets; the first is 0
};

/// Everything that was read. Tokens hold views into it, so it must outlive them, and it never moves a string.
struct Sources {
    std::deque<SourceFile> files;
    std::deque<std::string> spellings;  ///< texts without a file: pasted tokens, strings of macros
    std::vector<std::string> names;     ///< file names that a Location can name; #line adds to them

    std::int32_t name_index(std::string_view name);
    std::string_view keep(std::string spelling);
    SourceLocation place(Location location) const;
};

/// Largest file that is read, in bytes. Effects are a few hundred kilobytes at most; the limit rejects wrong paths (a
/// model, a film).
inline constexpr std::size_t max_source_bytes = 16u << 20;

/// The file's bytes. Nothing if it is not a regular file, cannot be read, or is larger than max_source_bytes; `reason`
/// then explains it.
std::optional<std::string> read_bytes(const std::string& path, std::string& reason);

SourceFile make_source(std::string path, std::string_view bytes);

}  // namespace permgen

// Files as the author wrote them, and the way back from any character to its line and column.
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

/// Where a run of consecutive characters of SourceFile::text stands in the author's file.
struct SourceRun {
    std::size_t offset = 0;
    std::int32_t line = 1;
    std::int32_t column = 1;
};

/// One file, made ready for the lexer: byte order mark gone, every line ends in a single '\n', lines
/// joined where they end in a backslash.
struct SourceFile {
    std::string path;
    std::string text;
    std::vector<SourceRun> runs;  ///< ascending offsets; the first is 0
};

/// Everything that was read. Tokens keep views into it, so it outlives them and never moves a string.
struct Sources {
    std::deque<SourceFile> files;
    std::deque<std::string> spellings;  ///< texts that stand in no file: pasted tokens, strings of macros
    std::vector<std::string> names;     ///< file names that a Location can name; #line adds to them

    std::int32_t name_index(std::string_view name);
    std::string_view keep(std::string spelling);
    SourceLocation place(Location location) const;
};

/// Largest file that is read, in bytes. Effects are a few hundred kilobytes at most; the limit stops a wrong
/// path (a model, a film) from being taken for one.
inline constexpr std::size_t max_source_bytes = 16u << 20;

/// The file's bytes. Nothing where it is not a regular file, cannot be read, or is larger than
/// max_source_bytes; `reason` then says why.
std::optional<std::string> read_bytes(const std::string& path, std::string& reason);

SourceFile make_source(std::string path, std::string_view bytes);

}  // namespace permgen

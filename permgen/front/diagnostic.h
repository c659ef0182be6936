// permgen's messages about an effect: a code with a fixed meaning, a source location, a sentence.
#pragma once

#include <string>
#include <vector>

namespace permgen {

/// A place in the author's own text; line and column count from 1, columns in bytes.
struct SourceLocation {
    std::string file;
    int line = 0;    ///< 0: the file as a whole
    int column = 0;  ///< 0: the line as a whole
};

enum class Severity { Error, Warning, Note };

struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;  ///< "PG001"; the list is in docs/diagnostics.md
    SourceLocation place;
    std::string message;  ///< the fault and its remedy
};

using Diagnostics = std::vector<Diagnostic>;

/// "file:line:column: error[PG001]: message"; parts that are 0 are left out. If the place has a column and its file can
/// be read, the author's line and a caret follow. No newline at the end.
std::string format(const Diagnostic& diagnostic);

bool has_errors(const Diagnostics& diagnostics);

}  // namespace permgen

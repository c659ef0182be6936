// Short ways to add a diagnostic.
#pragma once

#include <string>
#include <utility>

#include "front/diagnostic.h"

namespace permgen {

inline void report_error(Diagnostics& diagnostics, const char* code, SourceLocation place, std::string message) {
    diagnostics.push_back({Severity::Error, code, std::move(place), std::move(message)});
}

inline void report_warning(Diagnostics& diagnostics, const char* code, SourceLocation place, std::string message) {
    diagnostics.push_back({Severity::Warning, code, std::move(place), std::move(message)});
}

}  // namespace permgen

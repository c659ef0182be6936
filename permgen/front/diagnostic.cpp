#include "front/diagnostic.h"

#include <algorithm>

namespace permgen {

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
    return text;
}

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Error; });
}

}  // namespace permgen

#include "lower/read_effect.h"

#include <filesystem>

#include "front/parse.h"
#include "lower/lower.h"

namespace permgen {

Lowered read_effect(const std::string& path, const SourceOptions& options, Diagnostics& diagnostics) {
    Lowered lowered;
    Sources sources;
    Preprocessed preprocessed = preprocess(path, options, sources, diagnostics);
    // Tokens after a broken line would cause misleading errors.
    if (!has_errors(diagnostics)) {
        const ParsedEffect effect = parse(std::move(preprocessed.tokens), sources, diagnostics);
        if (!has_errors(diagnostics)) lowered = lower(effect, sources, diagnostics);
    }
    lowered.name = std::filesystem::path(path).stem().string();
    lowered.dependencies = std::move(preprocessed.dependencies);
    return lowered;
}

}  // namespace permgen

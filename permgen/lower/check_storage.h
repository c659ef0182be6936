// Storage images, storage buffers and groupshared variables: what their declarations and uses may be. glslang accepts
// some uses and changes their meaning.
#pragma once

#include "front/effect.h"
#include "lower/calls.h"
#include "lower/lowered.h"

namespace permgen {

/// The storage resource of that name, or nullptr.
const StorageResource* find_storage(const ParsedEffect& effect, std::string_view name);

bool is_writable(const StorageResource& storage);

/// The format of a storage image's texels; None for a buffer, and for an element type without a format.
ImageFormat texel_format(const ParsedEffect& effect, const StorageResource& storage);

void check_storage(const ParsedEffect& effect, const Sources& sources, const std::vector<Call>& calls,
                   Diagnostics& diagnostics);

}  // namespace permgen

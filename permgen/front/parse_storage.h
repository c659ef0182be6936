// Declarations of storage images and storage buffers: `RWTexture2D<float4> image : register(u0);`.
#pragma once

#include "front/parse_cursor.h"

namespace permgen {

/// True in front of such a declaration, qualifiers excluded.
bool begins_storage(const ParseCursor& cursor, std::size_t ahead);

void parse_storages(ParseCursor& cursor);

}  // namespace permgen

// Declarations of storage images and storage buffers: `RWTexture2D<float4> image : register(u0);`, with the attribute
// that names the format of the texels.
#pragma once

#include <optional>

#include "front/parse_cursor.h"

namespace permgen {

/// True in front of such a declaration, qualifiers excluded.
bool begins_storage(const ParseCursor& cursor, std::size_t ahead);

/// `format` is the attribute in front of the declaration, if there is one.
void parse_storages(ParseCursor& cursor, const std::optional<ImageFormatAttribute>& format);

/// Takes `[[vk::image_format("rgba16f")]]`, if it comes next, and drops it from the text, since lowering writes it in
/// the shader compiler's form.
std::optional<ImageFormatAttribute> parse_image_format(ParseCursor& cursor);

}  // namespace permgen

// Reads pictures to compare from OpenEXR and PNG files.
#pragma once

#include <kit/fail.h>
#include <kit/image/image.h>

#include <string>
#include <vector>

namespace tyndall {

struct ReadPicture {
    Image image;                        ///< linear
    std::vector<std::string> channels;  ///< names, in the image's order
    std::string encoding;               ///< "32-bit float", or how values became linear; for people
};

/// The content decides the format, not the extension. EXR: half or float, scanlines or tiles (the finest level), values
/// unchanged. PNG: 8 or 16 bits, colour and grey decoded from sRGB, alpha unchanged and not multiplied in.
/// Errors, each with the path: no such file, neither format, broken; an EXR that is deep, has several parts,
/// integer channels, or a data window that is not its display window; a side over longestSide.
Result<ReadPicture> readPicture(const std::string& path);

}  // namespace tyndall

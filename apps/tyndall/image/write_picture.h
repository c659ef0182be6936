// Picture files, written beside their place and then renamed, so that nobody meets half of one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "../outcome.h"
#include "picture.h"

namespace tyndall::app {

enum class PictureFormat { Png, Exr };

/// By the path's extension, in either case; absent where it is neither .png nor .exr.
std::optional<PictureFormat> pictureFormat(std::string_view path);

/// Whether a file can be made at `path`, to be asked before the work of filling it begins.
Outcome<void> checkWritable(const std::string& path);

/// PNG: tone-mapped to 8-bit sRGB. EXR: 32-bit float, as it is. Errors: a pixel that is not finite, a
/// place that cannot be written, another extension.
Outcome<void> writePicture(const std::string& path, const Picture& picture, std::optional<double> exposureStops);

/// Any text file, the same way.
Outcome<void> writeText(const std::string& path, std::string_view text);

}  // namespace tyndall::app

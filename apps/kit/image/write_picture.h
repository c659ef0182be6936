// Picture files, written beside their place and then renamed, so that nobody meets half of one. A link is
// followed: the file it names is what is written.
#pragma once

#include <study/metrics.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <kit/fail.h>
#include "picture.h"

namespace tyndall {

enum class PictureFormat { Png, Exr };

/// By the path's extension, in either case; absent where it is neither .png nor .exr.
std::optional<PictureFormat> pictureFormat(std::string_view path);

/// Whether a file can be made at `path`, to be asked before the work of filling it begins.
Result<void> checkWritable(const std::string& path);

/// Whether writing `a` would change `b`, through links too; what does not exist yet can still be the same.
bool sameFile(const std::string& a, const std::string& b);

/// PNG: tone-mapped to 8-bit sRGB. EXR: 32-bit float, as it is. Errors: a pixel that is not finite, a
/// place that cannot be written, another extension.
Result<void> writePicture(const std::string& path, const Picture& picture, std::optional<double> exposureStops);

/// An EXR of 32-bit floats with these channel names, whatever its values. Errors: a place that cannot be written.
Result<void> writeFloats(const std::string& path, const study::FloatImage& image,
                          const std::vector<std::string>& channels);

/// A PNG of RGB bytes as they are. Errors: a place that cannot be written.
Result<void> writeBytes(const std::string& path, std::uint32_t width, std::uint32_t height,
                         const std::vector<std::uint8_t>& rgb);

/// Any text file, the same way.
Result<void> writeText(const std::string& path, std::string_view text);

}  // namespace tyndall

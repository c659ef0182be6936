// Picture files, written atomically by writeFile().
#pragma once

#include <kit/fail.h>
#include <kit/image/image.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall {

enum class PictureFormat { Png, Exr };

/// By the path's extension, upper or lower case; absent if it is neither .png nor .exr.
std::optional<PictureFormat> pictureFormat(std::string_view path);

/// `image` has three channels. PNG: tone-mapped to 8-bit sRGB. EXR: 32-bit float, unchanged. Errors: a pixel that is
/// not finite, a place that cannot be written, another extension.
Result<void> writePicture(const std::string& path, const Image& picture, std::optional<double> exposureStops);

/// An EXR of 32-bit floats, losslessly compressed. NaN and infinity are kept. The same image gives
/// the same bytes. Without names the channels are R, G, B and A. Errors: a place that cannot be written.
Result<void> writeExr(const std::string& path, const Image& image, std::vector<std::string> channels = {});

/// A PNG of RGB bytes as they are. Errors: a place that cannot be written.
Result<void> writePng(const std::string& path, int width, int height, const std::vector<std::uint8_t>& rgb);

}  // namespace tyndall

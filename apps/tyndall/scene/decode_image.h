// PNG and JPEG as tinygltf decodes them, one image at a time and only when it is asked for.
#pragma once

#include <tiny_gltf.h>

#include <kit/fail.h>

namespace tyndall::app {

/// A loader for tinygltf that puts the file's bytes into Image::image as they are.
bool keepEncoded(tinygltf::Image* image, int index, std::string* error, std::string* warning, int width, int height,
                 const unsigned char* bytes, int size, void* user);

/// Four channels of 8 or 16 bits from what keepEncoded() kept; `index` names the image in messages.
Result<tinygltf::Image> decodeImage(const tinygltf::Image& encoded, std::size_t index);

}  // namespace tyndall::app

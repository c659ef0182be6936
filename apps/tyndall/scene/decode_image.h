// Decodes PNG and JPEG with tinygltf, one image at a time, on request.
#pragma once

#include <kit/fail.h>
#include <tiny_gltf.h>

namespace tyndall::app {

/// A loader for tinygltf that copies the file's bytes into Image::image.
bool keepEncoded(tinygltf::Image* image, int index, std::string* error, std::string* warning, int width, int height,
                 const unsigned char* bytes, int size, void* user);

/// Four channels of 8 or 16 bits from the bytes of keepEncoded(); `index` names the image in messages.
Result<tinygltf::Image> decodeImage(const tinygltf::Image& encoded, std::size_t index);

}  // namespace tyndall::app

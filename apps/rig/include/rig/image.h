// Reads the images that the rig compares.
#pragma once

#include <kit/fail.h>
#include <kit/image/write_picture.h>

#include <string>

namespace tyndall::rig {

/// Any image file that OpenImageIO reads, its first part and level; integer formats become 0 to 1 as they
/// are stored, without a change of colour space. At most 16384 pixels a side and 4 channels.
Result<Image> readImage(const std::string& path);

}  // namespace tyndall::rig

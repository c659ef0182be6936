// Base64 (RFC 4648), for pictures inside a page.
#pragma once

#include <string>
#include <string_view>

namespace tyndall::rig {

std::string base64(std::string_view bytes);

}  // namespace tyndall::rig

// How every library here says that something went wrong: a value with a reason. Libraries never print, never exit,
// and let no exception of their own out.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

namespace permgen {

/// What went wrong, for programs. The numbers keep their meaning from version to version.
enum class ErrorCode : std::uint16_t {
    InvalidArgument = 1,    ///< a value breaks a documented rule
    UnsupportedDevice = 2,  ///< the device lacks a feature or a format
    Vulkan = 3,             ///< a Vulkan call failed; `apiResult` has its VkResult
    File = 4,               ///< a file cannot be read or written
    Format = 5,             ///< a file was read and does not hold what it must
    Interrupted = 6,        ///< the caller stopped the work
    Inaccurate = 7,         ///< a result misses the accuracy or the limit that was asked for
};

struct Error {
    ErrorCode code = ErrorCode::InvalidArgument;
    std::string message;         ///< one sentence without a trailing newline: place, rule and remedy
    std::string place = {};      ///< what the message is about, as the message names it: "light 3", "scene.glb"; may be empty
    std::int32_t apiResult = 0;  ///< the API's own result where `code` is Vulkan
};

template <class T>
using Result = tl::expected<T, Error>;

}  // namespace permgen

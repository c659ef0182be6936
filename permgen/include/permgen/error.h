// The error value of every library here. Libraries never print, never exit, and throw none of their own exceptions to
// the caller.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

namespace permgen {

/// The kind of error, for programs. The numbers keep their meaning in all versions.
enum class ErrorCode : std::uint16_t {
    InvalidArgument = 1,    ///< a value breaks a documented rule
    UnsupportedDevice = 2,  ///< the device lacks a feature or a format
    Vulkan = 3,             ///< a Vulkan call failed; `apiResult` has its VkResult
    File = 4,               ///< a file cannot be read or written
    Format = 5,             ///< a file was read, but its content is invalid
    Interrupted = 6,        ///< the caller stopped the work
    Inaccurate = 7,         ///< a result misses the requested accuracy or limit
    Internal = 8,           ///< a fault of the library itself: please report it
};

struct Error {
    ErrorCode code = ErrorCode::InvalidArgument;
    std::string message;         ///< one sentence without a trailing newline: place, rule and remedy
    std::int32_t apiResult = 0;  ///< the API's own result if `code` is Vulkan
    std::string place = {};      ///< the subject of the message, in its words: "light 3"; may be empty
};

template <class T>
using Result = tl::expected<T, Error>;

}  // namespace permgen

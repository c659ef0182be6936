// How the runtime says that something went wrong: values, never exceptions, never output.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>
#include <tl/expected.hpp>

namespace tyndall {

enum class ErrorCode {
    InvalidArgument,    ///< the caller's values break a documented rule; the message names rule and remedy
    UnsupportedDevice,  ///< the device lacks a feature or format; the message names it
    Vulkan,             ///< a Vulkan call failed; `vk` has its result
};

struct Error {
    ErrorCode code;
    std::string message;       ///< one sentence, without a trailing newline
    VkResult vk = VK_SUCCESS;  ///< the API's own result where code is Vulkan
};

/// "VK_ERROR_DEVICE_LOST": the results that the calls made here can give, by name; others as "VkResult 7".
std::string resultName(VkResult result);

template <class T>
using Result = tl::expected<T, Error>;

}  // namespace tyndall

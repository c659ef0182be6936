// Messages of the validation layer, collected from any thread.
#pragma once

#include <vulkan/vulkan_core.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace headless {

struct MessageLog {
    mutable std::mutex mutex;
    std::vector<std::string> messages;
    std::function<void(const std::string&)> consumer;
    bool skipInvalidCalls = false;
};

/// Warnings and errors of the validation layers go to `log`, which must outlive the messenger.
VkDebugUtilsMessengerCreateInfoEXT messengerInfo(MessageLog& log);

}  // namespace headless

#include <tyndall/vulkan_result.h>

namespace tyndall {

std::string resultName(VkResult result) {
#define TYNDALL_NAME(name) \
    case name:             \
        return #name
    switch (result) {
        TYNDALL_NAME(VK_SUCCESS);
        TYNDALL_NAME(VK_NOT_READY);
        TYNDALL_NAME(VK_TIMEOUT);
        TYNDALL_NAME(VK_INCOMPLETE);
        TYNDALL_NAME(VK_ERROR_OUT_OF_HOST_MEMORY);
        TYNDALL_NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY);
        TYNDALL_NAME(VK_ERROR_INITIALIZATION_FAILED);
        TYNDALL_NAME(VK_ERROR_DEVICE_LOST);
        TYNDALL_NAME(VK_ERROR_MEMORY_MAP_FAILED);
        TYNDALL_NAME(VK_ERROR_LAYER_NOT_PRESENT);
        TYNDALL_NAME(VK_ERROR_EXTENSION_NOT_PRESENT);
        TYNDALL_NAME(VK_ERROR_FEATURE_NOT_PRESENT);
        TYNDALL_NAME(VK_ERROR_INCOMPATIBLE_DRIVER);
        TYNDALL_NAME(VK_ERROR_TOO_MANY_OBJECTS);
        TYNDALL_NAME(VK_ERROR_FORMAT_NOT_SUPPORTED);
        TYNDALL_NAME(VK_ERROR_FRAGMENTED_POOL);
        TYNDALL_NAME(VK_ERROR_OUT_OF_POOL_MEMORY);
        default:
            return "VkResult " + std::to_string(result);
    }
#undef TYNDALL_NAME
}

}  // namespace tyndall

// One-shot command buffers, and layout transitions for programs that can afford to wait.
#pragma once

#include <headless/device.h>
#include <headless/image.h>

#include <functional>
#include <type_traits>

namespace headless {

/// Records with `record`, submits, waits for the fence. Returns the milliseconds from the submission to
/// the fence's signal by the host's clock: recording is not counted. Timestamp queries are wrong on a
/// software device, a fence is not. If `record` returns an error, nothing is submitted and the error is returned.
Result<double> submitAndWait(const Device& device, const std::function<Result<void>(VkCommandBuffer)>& record);

/// The same for a recording that cannot fail.
template <class Record>
requires std::is_void_v<std::invoke_result_t<Record&, VkCommandBuffer>> Result<double> submitAndWait(
    const Device& device, Record&& record) {
    return submitAndWait(device, std::function<Result<void>(VkCommandBuffer)>([&](VkCommandBuffer commands) {
                             record(commands);
                             return Result<void>{};
                         }));
}

/// Moves the whole image from one layout to the other, after everything recorded before and before
/// everything recorded after. VK_IMAGE_LAYOUT_UNDEFINED as `from` discards its content.
void transition(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, VkImageLayout from,
                VkImageLayout to);
void transition(VkCommandBuffer commands, const Image& image, VkImageLayout from, VkImageLayout to);

/// A barrier between everything before and everything after.
void fullBarrier(VkCommandBuffer commands);

}  // namespace headless

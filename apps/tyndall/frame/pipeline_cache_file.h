// A Vulkan pipeline cache that is kept in a file between runs. It saves time and nothing else: whatever is wrong
// with the file is a note, and pipelines are then made anew.
#pragma once

#include <headless/device.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall::app {

/// What --pipeline-cache takes in place of a file.
constexpr std::string_view noPipelineCache = "none";

class PipelineCacheFile {
public:
    /// `asked` as RenderOptions::pipelineCache. A file that is not there makes no note; one that was not sealed for
    /// this device, was cut short or changed makes one and is not given to the driver.
    static PipelineCacheFile open(const headless::Device& device, const std::optional<std::string>& asked,
                                  std::vector<std::string>& notes);
    PipelineCacheFile(PipelineCacheFile&&) noexcept = default;
    PipelineCacheFile& operator=(PipelineCacheFile&&) = delete;
    ~PipelineCacheFile();

    /// Null where none is wanted or could be made.
    VkPipelineCache handle() const { return cache_; }

    /// Writes the cache where it differs from what the file held; makes the user's cache folder where there is none.
    /// A file that is not this program's is left alone.
    void save(std::vector<std::string>& notes);

    const std::string& path() const { return path_; }           ///< empty where nothing is kept
    std::size_t bytesLoaded() const { return bytesLoaded_; }    ///< that the driver was given
    std::size_t bytesWritten() const { return bytesWritten_; }  ///< to the file

private:
    explicit PipelineCacheFile(const headless::Device& device)
        : core_(device.core()), device_(device.device()), properties_(device.properties()) {}
    void create(std::span<const std::byte> data, std::vector<std::string>& notes);
    std::optional<std::vector<std::byte>> data(std::vector<std::string>& notes) const;

    std::shared_ptr<headless::DeviceCore> core_;  ///< keeps the device alive; empty once moved from
    VkDevice device_;
    VkPhysicalDeviceProperties properties_;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
    std::string path_;
    bool ours_ = true, makeFolder_ = false;
    std::vector<std::byte> held_;  ///< by the file, sealed
    std::size_t bytesLoaded_ = 0, bytesWritten_ = 0;
};

}  // namespace tyndall::app

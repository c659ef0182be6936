// A Vulkan pipeline cache that is kept in a file between runs. It only saves time: if the file is wrong,
// there is a note, and pipelines are made again.
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

/// The value of --pipeline-cache for no file.
constexpr std::string_view noPipelineCache = "none";

class PipelineCacheFile {
public:
    /// `asked` as RenderOptions::pipelineCache. A missing file gives no note. A file that was not sealed for
    /// this device, was truncated or changed gives a note, and the driver does not get it.
    static PipelineCacheFile open(const headless::Device& device, const std::optional<std::string>& asked,
                                  std::vector<std::string>& notes);
    PipelineCacheFile(PipelineCacheFile&&) noexcept = default;
    PipelineCacheFile& operator=(PipelineCacheFile&&) = delete;
    ~PipelineCacheFile();

    /// Null if none is wanted or could be made.
    VkPipelineCache handle() const { return cache_; }

    /// Writes the cache if it differs from the file's content; makes the user's cache folder if it is missing.
    /// Files of other programs are left unchanged.
    void save(std::vector<std::string>& notes);

    const std::string& path() const { return path_; }           ///< empty if nothing is kept
    std::size_t bytesLoaded() const { return bytesLoaded_; }    ///< given to the driver
    std::size_t bytesWritten() const { return bytesWritten_; }  ///< written to the file

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
    std::vector<std::byte> held_;  ///< the file's content, sealed
    std::size_t bytesLoaded_ = 0, bytesWritten_ = 0;
};

}  // namespace tyndall::app

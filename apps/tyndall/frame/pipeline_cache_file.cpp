#include "pipeline_cache_file.h"

#include <kit/image/files.h>
#include <sys/stat.h>
#include <tyndall/pipeline_cache.h>
#include <tyndall/vulkan_result.h>
#include <vulkan/vulkan.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace tyndall::app {
namespace {

/// Larger files are not from this program; drivers keep some kilobytes per pipeline.
constexpr std::uintmax_t maxBytes = std::uintmax_t{1} << 30;

/// "pipelines-" and the driver's identity, because drivers cannot use each other's caches.
std::string fileName(const VkPhysicalDeviceProperties& properties) {
    std::string name = "pipelines-";
    for (const std::uint8_t byte : properties.pipelineCacheUUID) name += fmt::format("{:02x}", byte);
    return name + ".bin";
}

/// XDG Base Directory Specification 0.8: a path that is not absolute counts as not set.
std::optional<std::filesystem::path> userCacheFolder() {
    const char* const cache = std::getenv("XDG_CACHE_HOME");
    if (cache && std::filesystem::path(cache).is_absolute()) return cache;
    const char* const home = std::getenv("HOME");
    if (home && std::filesystem::path(home).is_absolute()) return std::filesystem::path(home) / ".cache";
    return std::nullopt;
}

/// With the mode of the same specification. Errors appear when the file is written.
void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    if (folder.empty() || std::filesystem::exists(folder, error)) return;
    if (folder.has_relative_path()) makeFolder(folder.parent_path());
    ::mkdir(folder.c_str(), 0700);
}

/// Errors: not a plain file, cannot be read, too large.
Result<std::vector<std::byte>> readFile(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) return {};
    if (status.type() == std::filesystem::file_type::none)
        return fail(ErrorCode::File, "cannot be read: {}", error.message());
    if (status.type() != std::filesystem::file_type::regular) return fail(ErrorCode::File, "is not a plain file");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > maxBytes) return fail("is larger than any pipeline cache");
    std::vector<std::byte> bytes(size);
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!file || file.gcount() != static_cast<std::streamsize>(size)) return fail(ErrorCode::File, "cannot be read");
    return bytes;
}

std::string note(const std::string& path, std::string_view what) {
    return fmt::format("note: {}: {}", path, what);
}

}  // namespace

PipelineCacheFile PipelineCacheFile::open(const headless::Device& device, const std::optional<std::string>& asked,
                                          std::vector<std::string>& notes) {
    PipelineCacheFile file(device);
    if (asked == noPipelineCache) return file;
    if (asked) {
        file.path_ = *asked;
    } else if (const auto folder = userCacheFolder()) {
        file.path_ = (*folder / "tyndall" / fileName(device.properties())).string();
        file.makeFolder_ = true;
    } else {
        notes.push_back(
            "note: pipelines are not kept, because neither XDG_CACHE_HOME nor HOME names a folder; "
            "give a file with --pipeline-cache");
        return file;
    }
    auto bytes = readFile(file.path_);
    file.ours_ = bytes && isSealedPipelineCache(*bytes);
    if (!file.ours_) {
        notes.push_back(
            note(file.path_, fmt::format("{}; it is left unchanged: name another file with --pipeline-cache",
                                         bytes ? "is not a pipeline cache of this program" : bytes.error().message)));
        file.create({}, notes);
        return file;
    }
    file.held_ = std::move(*bytes);
    std::span<const std::byte> data;
    if (!file.held_.empty()) {
        const auto opened = openPipelineCache(file.held_, file.properties_);
        if (opened) data = *opened;
        if (!opened) notes.push_back(note(file.path_, opened.error().message + "; pipelines are made again"));
    }
    file.create(data, notes);
    return file;
}

PipelineCacheFile::~PipelineCacheFile() {
    if (core_) vkDestroyPipelineCache(device_, cache_, nullptr);
}

void PipelineCacheFile::create(std::span<const std::byte> data, std::vector<std::string>& notes) {
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    info.initialDataSize = data.size();
    info.pInitialData = data.data();
    const VkResult result = vkCreatePipelineCache(device_, &info, nullptr, &cache_);
    if (result == VK_SUCCESS) {
        bytesLoaded_ = data.size();
        return;
    }
    cache_ = VK_NULL_HANDLE;
    notes.push_back(note(path_, "the driver cannot make a pipeline cache from it: " + resultName(result)));
    if (!data.empty()) create({}, notes);
}

std::optional<std::vector<std::byte>> PipelineCacheFile::data(std::vector<std::string>& notes) const {
    std::vector<std::byte> bytes;
    std::size_t size = 0;
    VkResult result = vkGetPipelineCacheData(device_, cache_, &size, nullptr);
    if (result == VK_SUCCESS) {
        bytes.resize(size);
        result = vkGetPipelineCacheData(device_, cache_, &size, bytes.data());
        bytes.resize(size);
    }
    // The cache does not grow in between, so VK_INCOMPLETE is an error here.
    if (result == VK_SUCCESS) return bytes;
    notes.push_back(note(path_, "the driver does not return its pipeline cache: " + resultName(result)));
    return std::nullopt;
}

void PipelineCacheFile::save(std::vector<std::string>& notes) {
    if (!cache_ || !ours_) return;
    const auto bytes = data(notes);
    if (!bytes) return;
    const std::vector<std::byte> sealed = sealPipelineCache(*bytes, properties_);
    if (sealed == held_) return;
    if (makeFolder_) makeFolder(std::filesystem::path(path_).parent_path());
    const auto written =
        writeFile(path_, std::string_view(reinterpret_cast<const char*>(sealed.data()), sealed.size()));
    if (!written) {
        notes.push_back(fmt::format("note: pipelines are not kept: {}", written.error().message));
        return;
    }
    held_ = sealed;
    bytesWritten_ = held_.size();
}

}  // namespace tyndall::app

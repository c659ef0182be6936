#include <common/write_files.h>
#include <kit/image/files.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace tyndall {
namespace {

/// The file that `path` leads to through symbolic links; the file need not exist.
Result<std::filesystem::path> written(const std::string& path) {
    constexpr int maxLinks = 40;  // as many as Linux follows
    std::filesystem::path at(path);
    for (int links = 0; links < maxLinks; ++links) {
        std::error_code error;
        if (!std::filesystem::is_symlink(at, error)) return at;
        const std::filesystem::path next = std::filesystem::read_symlink(at, error);
        if (error) return at;
        at = next.is_absolute() ? next : at.parent_path() / next;
    }
    return fail(ErrorCode::File, "{}: is a symbolic link in a cycle; choose another place", path);
}

/// A temporary name beside the file, to test whether its folder can be written.
std::string besidePath(const std::filesystem::path& whole) {
    return (whole.parent_path() / fmt::format(".{}.{}.partial", whole.filename().string(), ::getpid())).string();
}

}  // namespace

Result<void> checkWritable(const std::string& path) {
    std::error_code error;
    const auto target = written(path);
    if (!target) return tl::unexpected(target.error());
    if (std::filesystem::is_directory(*target, error))
        return fail(ErrorCode::File, "{}: is a folder; name a file", path);
    // The final rename would replace a device or a pipe with a plain file.
    if (std::filesystem::exists(*target, error) && !std::filesystem::is_regular_file(*target, error))
        return fail(ErrorCode::File, "{}: is not a plain file; choose another place", path);
    const std::string partial = besidePath(*target);
    errno = 0;
    const bool opened = std::ofstream(partial).is_open();
    const int reason = errno;
    if (!opened)
        return fail(ErrorCode::File, "{}: cannot be written: {}; choose another place", path, std::strerror(reason));
    std::filesystem::remove(partial, error);
    return {};
}

bool sameFile(const std::string& a, const std::string& b) {
    std::error_code error;
    if (std::filesystem::equivalent(a, b, error)) return true;
    const auto first = written(a), second = written(b);
    return first && second &&
           std::filesystem::weakly_canonical(*first, error) == std::filesystem::weakly_canonical(*second, error);
}

Result<void> writeFile(const std::string& path, std::string_view bytes) {
    const auto target = written(path);
    if (!target) return tl::unexpected(target.error());
    // write_files() makes missing folders; here a missing folder is a mistake in the path.
    const std::filesystem::path folder = target->has_parent_path() ? target->parent_path() : ".";
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error))
        return fail(ErrorCode::File, "{}: cannot be written: {} is not a folder; choose another place", path,
                    folder.string());
    if (const auto done = permgen::write_files({{target->string(), std::string(bytes)}}); !done)
        return fail(ErrorCode::File, "{}: cannot be written: {}; choose another place", path, done.error().message);
    return {};
}

}  // namespace tyndall

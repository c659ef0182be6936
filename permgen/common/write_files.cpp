#include "common/write_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace permgen {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& path, const std::string& bytes) {
    std::error_code error;
    if (!fs::is_regular_file(path, error) || fs::file_size(path, error) != bytes.size()) return false;
    std::ifstream file(path, std::ios::binary);
    const std::string there((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    return file && there == bytes;
}

std::string cannot(const std::string& what, const fs::path& path, int error) {
    return "cannot " + what + " '" + path.string() + "': " + std::strerror(error);
}

/// Writes and closes; 0 or errno.
int write_new_file(const fs::path& path, const std::string& bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) return errno;
    int error = 0;
    for (std::size_t at = 0; at < bytes.size() && error == 0;) {
        const ssize_t written = ::write(file, bytes.data() + at, bytes.size() - at);
        if (written >= 0)
            at += static_cast<std::size_t>(written);
        else if (errno != EINTR)
            error = errno;
    }
    if (::close(file) != 0 && error == 0) error = errno;
    return error;
}

/// The steps taken so far; its destructor undoes them unless keep() was called.
class Transaction {
public:
    ~Transaction();
    std::string make_folder(const fs::path& folder);
    std::string stage(const OutputFile& file);
    std::string publish();
    void keep();

private:
    struct Staged {
        fs::path target;
        fs::path temporary;
        fs::path backup;        ///< a hard link to the old file, if the file system allows one
        bool replaces = false;  ///< an old file existed
        bool published = false;
    };
    std::vector<fs::path> folders_;
    std::vector<Staged> staged_;
};

std::string Transaction::make_folder(const fs::path& folder) {
    std::vector<fs::path> missing;
    std::error_code error;
    for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) missing.push_back(at);
    for (auto it = missing.rbegin(); it != missing.rend(); ++it) {
        if (::mkdir(it->c_str(), 0777) == 0)
            folders_.push_back(*it);
        else if (errno != EEXIST)
            return cannot("make the folder", *it, errno) + "; choose a folder that can be written to";
    }
    if (!folder.empty() && !fs::is_directory(folder, error))
        return "cannot write into '" + folder.string() + "': it is not a folder; choose another";
    return {};
}

std::string Transaction::stage(const OutputFile& file) {
    const fs::path target = file.path;
    if (std::string why = make_folder(target.parent_path()); !why.empty()) return why;
    std::error_code error;
    if (fs::exists(target, error) && !fs::is_regular_file(target, error))
        return "cannot write '" + target.string() + "': it exists and is not a file; remove it";
    if (holds(target, file.bytes)) return {};
    const std::string stem = "." + target.filename().string() + "." + std::to_string(::getpid());
    staged_.push_back({target, target.parent_path() / (stem + ".new"), {}, fs::exists(target, error)});
    if (const int failed = write_new_file(staged_.back().temporary, file.bytes))
        return cannot("write", target, failed) + "; what was there before is untouched";
    if (staged_.back().replaces) {
        const fs::path backup = target.parent_path() / (stem + ".old");
        // A file system without hard links cannot undo a failed move; moves within a folder rarely fail.
        if (::link(target.c_str(), backup.c_str()) == 0) staged_.back().backup = backup;
    }
    return {};
}

std::string Transaction::publish() {
    for (Staged& staged : staged_) {
        if (::rename(staged.temporary.c_str(), staged.target.c_str()) != 0)
            return cannot("replace", staged.target, errno) + "; what was there before is untouched";
        staged.published = true;
    }
    return {};
}

void Transaction::keep() {
    for (const Staged& staged : staged_)
        if (!staged.backup.empty()) ::unlink(staged.backup.c_str());
    staged_.clear();
    folders_.clear();
}

Transaction::~Transaction() {
    for (const Staged& staged : staged_) {
        if (!staged.published)
            ::unlink(staged.temporary.c_str());
        else if (!staged.replaces)
            ::unlink(staged.target.c_str());
        if (staged.backup.empty()) continue;
        if (staged.published)
            ::rename(staged.backup.c_str(), staged.target.c_str());
        else
            ::unlink(staged.backup.c_str());
    }
    for (auto folder = folders_.rbegin(); folder != folders_.rend(); ++folder) ::rmdir(folder->c_str());
}

}  // namespace

Result<void> write_files(const std::vector<OutputFile>& files) {
    const auto failed = [](std::string why) { return tl::unexpected(Error{ErrorCode::File, std::move(why)}); };
    Transaction transaction;
    for (const OutputFile& file : files)
        if (std::string why = transaction.stage(file); !why.empty()) return failed(std::move(why));
    if (std::string why = transaction.publish(); !why.empty()) return failed(std::move(why));
    transaction.keep();
    return {};
}

}  // namespace permgen

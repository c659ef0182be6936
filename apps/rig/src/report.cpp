#include <fcntl.h>
#include <fmt/format.h>
#include <kit/fail.h>
#include <kit/image/files.h>
#include <rig/report.h>
#include <sys/file.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "report_entry.h"
#include "report_page.h"

namespace tyndall::rig {
namespace {

namespace fs = std::filesystem;

const std::string anotherPage = "its index.html is not a page of failing comparisons, and would be lost";

/// A lock held by one process at a time; the kernel releases it if the process ends.
class FolderLock {
public:
    explicit FolderLock(const fs::path& folder)
        : file_(::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        if (file_ < 0) return;
        int status = 0;
        do status = ::flock(file_, LOCK_EX);
        while (status != 0 && errno == EINTR);
        held_ = status == 0;
    }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock() {
        if (file_ >= 0) ::close(file_);
    }
    bool held() const { return held_; }

private:
    int file_;
    bool held_ = false;
};

tl::unexpected<Error> cannotWrite(const fs::path& folder, const std::string& reason) {
    return failWith(
        fmt::format("{}: the report cannot be written: {}; choose another folder", folder.string(), reason));
}

/// The folder may hold another page, such as a web site, which must not be overwritten.
bool holdsAnotherPage(const fs::path& folder) {
    const fs::path page = folder / "index.html";
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(page, ignored))) return false;
    if (!fs::is_regular_file(page, ignored)) return true;
    constexpr std::size_t head = 1024;  // the title is in the first 200 bytes
    std::string start(head, '\0');
    std::ifstream file(page, std::ios::binary);
    file.read(start.data(), head);
    return start.find(pageMark) == std::string::npos;
}

Result<void> rebuildPage(const fs::path& folder) {
    if (holdsAnotherPage(folder)) return cannotWrite(folder, anotherPage);
    const auto written = writeFile((folder / "index.html").string(), reportPage((folder / "entries").string()));
    if (!written) return cannotWrite(folder, written.error().message);
    return {};
}

/// FNV-1a, 32 bits: distinguishes keys that become equal when special characters are replaced.
std::uint32_t hashOf(std::string_view text) {
    std::uint32_t hash = 2166136261u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash;
}

Result<void> replaceEntry(const fs::path& folder, const Failure& failure, const Image* image, const Image* expected) {
    const fs::path place = folder / "entries" / entryKey(failure.subject);
    const fs::path partial = folder / fmt::format(".partial.{}", ::getpid());
    std::error_code error;
    fs::remove_all(partial, error);
    if (!fs::create_directory(partial, error)) return cannotWrite(folder, error.message());
    if (auto written = writeEntry(partial, failure, image, expected); !written) {
        fs::remove_all(partial, error);
        return cannotWrite(folder, written.error().message);
    }
    fs::remove_all(place, error);
    fs::rename(partial, place, error);
    if (error) return cannotWrite(folder, error.message());
    return {};
}

}  // namespace

std::string entryKey(const Subject& subject) {
    constexpr std::size_t readable = 120;  // file names have at most 255 bytes
    const std::string whole = subject.effect + '\n' + subject.technique + '\n' + subject.pass + '\n' + subject.check;
    std::string key;
    for (const std::string* part : {&subject.effect, &subject.technique, &subject.pass, &subject.check}) {
        if (part->empty()) continue;
        if (!key.empty()) key += '.';
        for (const char c : *part) key += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
    }
    return fmt::format("{}.{:08x}", key.substr(0, readable), hashOf(whole));
}

Result<void> reportFailure(const std::string& folder, const Failure& failure, const Image* image,
                           const Image* expected) {
    if (holdsAnotherPage(folder)) return cannotWrite(folder, anotherPage);
    std::error_code error;
    fs::create_directories(fs::path(folder) / "entries", error);
    if (error) return cannotWrite(folder, error.message());
    const FolderLock lock(folder);
    if (!lock.held()) return cannotWrite(folder, std::strerror(errno));
    if (auto replaced = replaceEntry(folder, failure, image, expected); !replaced) return replaced;
    return rebuildPage(folder);
}

Result<void> reportPass(const std::string& folder, const Subject& subject) {
    const fs::path place = fs::path(folder) / "entries" / entryKey(subject);
    std::error_code error;
    if (!fs::exists(place, error)) return {};
    const FolderLock lock(folder);
    if (!lock.held()) return cannotWrite(folder, std::strerror(errno));
    fs::remove_all(place, error);
    if (error) return cannotWrite(folder, error.message());
    return rebuildPage(folder);
}

Result<void> reportTechniques(const std::string& folder, const std::string& effect,
                              const std::vector<std::string>& techniques) {
    const std::string entries = (fs::path(folder) / "entries").string();
    std::error_code error;
    if (!fs::exists(entries, error)) return {};
    const FolderLock lock(folder);
    if (!lock.held()) return cannotWrite(folder, std::strerror(errno));
    const std::vector<fs::path> gone = entriesOfOtherTechniques(entries, effect, techniques);
    for (const fs::path& entry : gone) {
        fs::remove_all(entry, error);
        if (error) return cannotWrite(folder, error.message());
    }
    if (gone.empty()) return {};
    return rebuildPage(folder);
}

std::string shellCommand(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        if (!line.empty()) line += ' ';
        const bool plain = !word.empty() && word.find_first_not_of(
                                                "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                "0123456789_-+=:,./@%") == std::string::npos;
        if (plain) {
            line += word;
            continue;
        }
        line += '\'';
        for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += '\'';
    }
    return line;
}

}  // namespace tyndall::rig

// A temporary folder that is removed after the test.
#pragma once

#include <filesystem>
#include <string>

namespace tyndall::test {

class Folder {
public:
    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();

    std::string path() const { return path_.string(); }
    std::string at(const std::string& name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

std::string readText(const std::string& path);
void writeText(const std::string& path, const std::string& text);

/// Every file below, as paths from the folder, sorted; hidden ones too.
std::string listing(const std::string& folder);

}  // namespace tyndall::test

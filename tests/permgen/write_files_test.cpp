#include "common/write_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace permgen {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string whyFailed(const Result<void>& done) {
    if (done) return {};
    EXPECT_EQ(done.error().code, ErrorCode::File);
    return done.error().message;
}

class WriteFiles : public testing::Test {
protected:
    WriteFiles() {
        std::string pattern = testing::TempDir() + "write_files_XXXXXX";
        folder = ::mkdtemp(pattern.data());
    }
    ~WriteFiles() override { fs::remove_all(folder); }

    std::string at(const std::string& name) const { return (folder / name).string(); }
    void put(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    /// Everything in the folder, by path.
    std::vector<std::string> listing() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            all.push_back(fs::relative(entry.path(), folder).string());
        std::sort(all.begin(), all.end());
        return all;
    }
    using Names = std::vector<std::string>;
    fs::path folder;
};

TEST_F(WriteFiles, MakesFoldersAndLeavesNothingElse) {
    EXPECT_EQ(whyFailed(write_files({{at("a/b/one"), "1"}, {at("two"), std::string("\0x", 2)}})), "");
    EXPECT_EQ(read(at("a/b/one")), "1");
    EXPECT_EQ(read(at("two")), std::string("\0x", 2));
    EXPECT_EQ(listing(), (Names{"a", "a/b", "a/b/one", "two"}));
}

TEST_F(WriteFiles, ReplacesWhatChanged) {
    put("one", "old");
    EXPECT_EQ(whyFailed(write_files({{at("one"), "new"}})), "");
    EXPECT_EQ(read(at("one")), "new");
    EXPECT_EQ(listing(), Names{"one"});
}

TEST_F(WriteFiles, LeavesAloneWhatDidNotChange) {
    put("one", "same");
    const auto before = fs::last_write_time(at("one")) - std::chrono::hours(1);
    fs::last_write_time(at("one"), before);
    EXPECT_EQ(whyFailed(write_files({{at("one"), "same"}, {at("two"), "new"}})), "");
    EXPECT_EQ(fs::last_write_time(at("one")), before);
}

TEST_F(WriteFiles, AFolderInTheWayStopsEverything) {
    put("one", "old");
    fs::create_directory(at("two"));
    const std::string why = whyFailed(write_files({{at("one"), "new"}, {at("sub/x"), "x"}, {at("two"), "new"}}));
    EXPECT_NE(why.find("two': it exists and is not a file"), std::string::npos) << why;
    EXPECT_EQ(read(at("one")), "old");
    EXPECT_EQ(listing(), (Names{"one", "two"}));
}

TEST_F(WriteFiles, AFileWhereAFolderShouldBeStopsEverything) {
    put("one", "old");
    const std::string why = whyFailed(write_files({{at("one/two"), "new"}}));
    EXPECT_NE(why.find("one': it is not a folder"), std::string::npos) << why;
    EXPECT_EQ(read(at("one")), "old");
    EXPECT_EQ(listing(), Names{"one"});
}

TEST_F(WriteFiles, ANameThatIsTooLongIsToldAndUndone) {
    put("one", "old");
    const std::string why = whyFailed(write_files({{at("one"), "new"}, {at(std::string(300, 'n')), "new"}}));
    EXPECT_NE(why.find("File name too long"), std::string::npos) << why;
    EXPECT_EQ(read(at("one")), "old");
    EXPECT_EQ(listing(), Names{"one"});
}

/// A limit on file sizes simulates a full disk: write() fails after some of the bytes.
TEST_F(WriteFiles, AFullDiskLeavesEverythingAsItWas) {
    put("one", "old");
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    rlimit small = limit;
    small.rlim_cur = 1000;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string why =
        whyFailed(write_files({{at("one"), "new"}, {at("new/two"), "2"}, {at("three"), std::string(100'000, 'x')}}));
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, handler);
    EXPECT_NE(why.find("cannot write '" + at("three") + "': File too large"), std::string::npos) << why;
    EXPECT_EQ(read(at("one")), "old");
    EXPECT_EQ(listing(), Names{"one"});
}

/// The second move of the same file fails because the file is gone. No other failure there is possible without a race.
TEST_F(WriteFiles, AMoveThatFailsUndoesThoseBefore) {
    put("one", "old");
    const std::string why = whyFailed(write_files({{at("two"), "2"}, {at("one"), "new"}, {at("one"), "newer"}}));
    EXPECT_NE(why.find("cannot replace '" + at("one")), std::string::npos) << why;
    EXPECT_EQ(read(at("one")), "old");
    EXPECT_EQ(listing(), Names{"one"});
}

TEST_F(WriteFiles, AFolderThatMayNotBeWrittenIsTold) {
    fs::create_directory(at("locked"));
    ::chmod(at("locked").c_str(), 0555);
    const std::string target = ::geteuid() == 0 ? "/proc/locked/one" : at("locked/one");  // root may write anywhere
    const std::string why = whyFailed(write_files({{target, "1"}}));
    EXPECT_NE(why.find("cannot "), std::string::npos) << why;
    EXPECT_EQ(listing(), Names{"locked"});
}

TEST_F(WriteFiles, WhatIsNoFileIsNotReplaced) {
    ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);  // instead of /dev/null, which a test should not risk
    const std::string why = whyFailed(write_files({{at("pipe"), "1"}}));
    EXPECT_NE(why.find("it exists and is not a file"), std::string::npos) << why;
    EXPECT_TRUE(fs::is_fifo(at("pipe")));
}

}  // namespace
}  // namespace permgen

// A failure adds its entry to the report; a pass removes it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <rig/report.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "folder.h"

namespace tyndall::rig {
namespace {

using test::Folder;

Image grey(float value) {
    Image image = blankImage(8, 6, 4);
    for (float& v : image.values) v = value;
    return image;
}

Failure failureOf(const std::string& technique, const std::string& check = "golden") {
    return {{"slices", technique, "p0", check}, {{"bCookie", "true"}, {"fGain", "0.5"}}, "it is off", "run 'this'"};
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(Report, AFailureLeavesItsPicturesItsFiguresAndAPage) {
    const Folder folder;
    Image image = grey(0.5f);
    image.at(3, 2, 1) = 0.75f;
    image.at(4, 2, 0) = std::numeric_limits<float>::quiet_NaN();
    const Image expected = grey(0.5f);
    const Failure failure = failureOf("lamp");
    const auto reported = reportFailure(folder.path(), failure, &image, &expected);
    ASSERT_TRUE(reported.has_value()) << reported.error().message;

    const std::string entry = "entries/" + entryKey(failure.subject) + "/";
    EXPECT_EQ(test::listing(folder.path()), ".lock\n" + entry + "difference.exr\n" + entry + "difference.png\n" +
                                                entry + "entry.json\n" + entry + "expected.exr\n" + entry +
                                                "expected.png\n" + entry + "image.exr\n" + entry +
                                                "image.png\nindex.html\n");
    const auto json = nlohmann::json::parse(test::readText(folder.at(entry + "entry.json")));
    EXPECT_EQ(json["effect"], "slices");
    EXPECT_EQ(json["technique"], "lamp");
    EXPECT_EQ(json["pass"], "p0");
    EXPECT_EQ(json["check"], "golden");
    EXPECT_EQ(json["constants"]["bCookie"], "true");
    EXPECT_EQ(json["command"], "run 'this'");
    EXPECT_EQ(json["figures"]["nan"], 1);
    EXPECT_EQ(json["figures"]["infinite"], 0);
    EXPECT_EQ(json["figures"]["largest_difference"], 0.25);
    EXPECT_EQ(json["figures"]["largest_difference_at"]["pixel"], nlohmann::json({3, 2}));

    const Image apart = *readImage(folder.at(entry + "difference.exr"));
    EXPECT_EQ(apart.at(3, 2, 1), 0.25f);
    EXPECT_EQ(apart.at(0, 0, 0), 0.0f);
    // NaN is magenta in the picture and in the difference, and only there.
    for (const std::string name : {"image.png", "difference.png"}) {
        const Image shown = *readImage(folder.at(entry + name));
        EXPECT_EQ(shown.at(4, 2, 0), 1.0f) << name;
        EXPECT_EQ(shown.at(4, 2, 1), 0.0f) << name;
        EXPECT_EQ(shown.at(4, 2, 2), 1.0f) << name;
        EXPECT_NE(shown.at(5, 2, 1), shown.at(5, 2, 0) + 1.0f) << name;
    }
}

TEST(Report, ThePageHoldsEverythingItShows) {
    const Folder folder;
    const Image image = grey(0.5f), expected = grey(0.25f);
    Failure failure = failureOf("a<b>&\"c\"");
    failure.reason = "1 < 2 & so on";
    ASSERT_TRUE(reportFailure(folder.path(), failure, &image, &expected).has_value());
    ASSERT_TRUE(reportFailure(folder.path(), failureOf("lamp"), &image, nullptr).has_value());
    ASSERT_TRUE(reportFailure(folder.path(), failureOf("dark"), nullptr, nullptr).has_value());
    const std::string page = test::readText(folder.at("index.html"));
    EXPECT_EQ(count(page, "<img "), 4u);
    EXPECT_EQ(count(page, "src=\"data:image/png;base64,iVBOR"), 4u);
    EXPECT_EQ(count(page, "src="), 4u);
    EXPECT_EQ(count(page, "href="), 3u);  // links to the articles below
    EXPECT_EQ(count(page, "href=\"#"), 3u);
    for (const char* outside : {"http:", "https:", "<script", "<link", "@import", "url("})
        EXPECT_EQ(count(page, outside), 0u) << outside;
    EXPECT_EQ(count(page, "<article "), 3u);
    EXPECT_EQ(count(page, "a&lt;b&gt;&amp;&quot;c&quot;</h2>"), 1u);
    EXPECT_EQ(count(page, "1 &lt; 2 &amp; so on"), 1u);
    EXPECT_EQ(count(page, "run 'this'"), 3u);
    EXPECT_EQ(count(page, "bCookie = true"), 3u);
    EXPECT_EQ(count(page, "no image to compare with"), 1u);
}

TEST(Report, TheSameComparisonFailingAgainReplacesItsEntry) {
    const Folder folder;
    const Image image = grey(0.5f);
    ASSERT_TRUE(reportFailure(folder.path(), failureOf("lamp"), &image, &image).has_value());
    Failure again = failureOf("lamp");
    again.reason = "another reason";
    ASSERT_TRUE(reportFailure(folder.path(), again, nullptr, nullptr).has_value());
    const std::string page = test::readText(folder.at("index.html"));
    EXPECT_EQ(count(page, "<article "), 1u);
    EXPECT_EQ(count(page, "another reason"), 1u);
    EXPECT_EQ(count(page, "<img"), 0u);
}

TEST(Report, APassTakesItsOwnEntryAwayAndNoOther) {
    const Folder folder;
    const Image image = grey(0.5f);
    ASSERT_TRUE(reportFailure(folder.path(), failureOf("lamp"), &image, nullptr).has_value());
    ASSERT_TRUE(reportFailure(folder.path(), failureOf("lamp", "oracle"), &image, nullptr).has_value());
    ASSERT_TRUE(reportPass(folder.path(), failureOf("lamp").subject).has_value());
    std::string page = test::readText(folder.at("index.html"));
    EXPECT_EQ(count(page, "<article "), 1u);
    EXPECT_EQ(count(page, ": oracle"), 1u);
    ASSERT_TRUE(reportPass(folder.path(), failureOf("lamp", "oracle").subject).has_value());
    EXPECT_EQ(test::listing(folder.path()), ".lock\nindex.html\n");
    EXPECT_EQ(count(test::readText(folder.at("index.html")), "Nothing fails"), 1u);
}

TEST(Report, TechniquesThatAreGoneAreForgottenAndThoseOfOtherEffectsAreNot) {
    const Folder folder;
    Failure elsewhere = failureOf("renamed");
    elsewhere.subject.effect = "cel";
    for (const Failure& failure : {failureOf("renamed"), failureOf("renamed", "oracle"), failureOf("lamp"), elsewhere})
        ASSERT_TRUE(reportFailure(folder.path(), failure, nullptr, nullptr).has_value());
    ASSERT_TRUE(reportTechniques(folder.path(), "slices", {"lamp", "new_name"}).has_value());
    const std::string page = test::readText(folder.at("index.html"));
    EXPECT_EQ(count(page, "<article "), 2u);
    EXPECT_EQ(count(page, "<h2>lamp</h2>"), 1u);
    EXPECT_EQ(count(page, "cel.fx"), 1u);
    ASSERT_TRUE(reportTechniques(folder.at("none"), "slices", {}).has_value());
    EXPECT_FALSE(std::filesystem::exists(folder.at("none")));
}

TEST(Report, APassMakesNoFolder) {
    const Folder folder;
    ASSERT_TRUE(reportPass(folder.at("report"), failureOf("lamp").subject).has_value());
    EXPECT_EQ(test::listing(folder.path()), "");
    EXPECT_FALSE(std::filesystem::exists(folder.at("report")));
}

TEST(Report, KeysAreFileNamesAndDifferWhereSubjectsDo) {
    const auto key = [](const std::string& effect, const std::string& check) {
        return entryKey({effect, "t", "", check});
    };
    EXPECT_NE(key("a", "b c"), key("a", "b_c"));
    EXPECT_NE(entryKey({"a", "b.c", "", "d"}), entryKey({"a", "b", "c", "d"}));
    const std::string longest = key("../" + std::string(1000, 'x'), "/");
    EXPECT_LT(longest.size(), 200u);
    EXPECT_EQ(longest.find('/'), std::string::npos);
    EXPECT_NE(longest.substr(0, 2), "..");
    EXPECT_NE(longest, key("../" + std::string(1001, 'x'), "/"));
}

TEST(Report, ABrokenEntryIsNamedAndTheOthersAreShown) {
    const Folder folder;
    test::writeText(folder.at("entries/old.1/entry.json"), "{");
    test::writeText(folder.at("entries/old.2/entry.json"), R"({"figures": {"largest_difference": 1}})");
    ASSERT_TRUE(reportFailure(folder.path(), failureOf("lamp"), nullptr, nullptr).has_value());
    const std::string page = test::readText(folder.at("index.html"));
    EXPECT_EQ(count(page, "cannot be read"), 1u);
    EXPECT_EQ(count(page, "another form"), 1u);
    EXPECT_EQ(count(page, "<h2>lamp</h2>"), 1u);
}

TEST(Report, AFolderThatCannotBeWrittenIsNamed) {
    const Folder folder;
    test::writeText(folder.at("report"), "a file where the folder should be");
    const auto reported = reportFailure(folder.at("report"), failureOf("lamp"), nullptr, nullptr);
    ASSERT_FALSE(reported.has_value());
    EXPECT_NE(reported.error().message.find(folder.at("report")), std::string::npos) << reported.error().message;
}

TEST(Report, AStrangersPageIsKept) {
    const std::string theirs = "<!doctype html><title>My garden</title>";
    for (const std::string& page : {theirs, std::string()}) {
        const Folder folder;
        test::writeText(folder.at("index.html"), page);
        const auto reported = reportFailure(folder.path(), failureOf("lamp"), nullptr, nullptr);
        ASSERT_FALSE(reported.has_value());
        EXPECT_EQ(reported.error().message,
                  folder.path() +
                      ": the report cannot be written: its index.html is not a page of failing "
                      "comparisons, and would be lost; choose another folder");
        EXPECT_EQ(test::listing(folder.path()), "index.html\n");
        EXPECT_EQ(test::readText(folder.at("index.html")), page);
    }
}

// A page put there after the report is not overwritten by a later pass either.
TEST(Report, AStrangersPageIsKeptWhenAFailurePasses) {
    const Folder folder;
    ASSERT_TRUE(reportFailure(folder.path(), failureOf("lamp"), nullptr, nullptr).has_value());
    test::writeText(folder.at("index.html"), "My garden");
    EXPECT_FALSE(reportPass(folder.path(), failureOf("lamp").subject).has_value());
    EXPECT_EQ(test::readText(folder.at("index.html")), "My garden");
}

// ctest runs many test processes at once. The last process writes a page with the entries of all.
TEST(Report, ProcessesThatReportAtOnceLoseNothing) {
    const Folder folder;
    constexpr int processes = 4, each = 5;  // each process removes its first entry
    std::string command;
    for (int p = 0; p < processes; ++p)
        command += shellCommand({REPORT_WORKER, folder.path(), "t" + std::to_string(p) + "_", std::to_string(each)}) +
                   " & P" + std::to_string(p) + "=$!; ";
    for (int p = 0; p < processes; ++p) command += (p ? " && wait $P" : "wait $P") + std::to_string(p);
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(count(test::readText(folder.at("index.html")), "<article "), std::size_t(processes * (each - 1)));
    EXPECT_EQ(test::listing(folder.path()).find(".partial"), std::string::npos);
}

// Without the lock, an entry written after another process has read the entries would be missing from its page.
TEST(Report, WaitsForWhoeverHoldsTheFolder) {
    const Folder folder;
    std::filesystem::create_directory(folder.at("entries"));
    const int lock = open(folder.at(".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    ASSERT_EQ(flock(lock, LOCK_EX), 0);
    FILE* worker = popen(shellCommand({REPORT_WORKER, folder.path(), "t", "2"}).c_str(), "r");
    ASSERT_NE(worker, nullptr);
    std::this_thread::sleep_for(std::chrono::seconds(1));
    EXPECT_EQ(test::listing(folder.path()), ".lock\n");
    close(lock);
    EXPECT_EQ(pclose(worker), 0);
    EXPECT_EQ(count(test::readText(folder.at("index.html")), "<article "), 1u);
}

TEST(Report, CommandsAreQuotedForTheShell) {
    EXPECT_EQ(shellCommand({"a", "--b=c/d", "x y", "it's", ""}), "a --b=c/d 'x y' 'it'\\''s' ''");
}

}  // namespace
}  // namespace tyndall::rig

#include "judge.h"

#include <gtest/gtest.h>
#include <rig/report.h>

#include <cstdlib>
#include <filesystem>

namespace tyndall::test {
namespace {

std::string environment(const char* name, const std::string& fallback = {}) {
    const char* value = std::getenv(name);
    return value && *value ? value : fallback;
}

std::string reportFolder() {
    return environment("TYNDALL_REPORT", TYNDALL_REPORT_FOLDER);
}

/// The command that repeats this test: environment variables that change its picture, this program, this test.
std::string thisTestsCommand() {
    std::vector<std::string> words{"env"};
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "TYNDALL_EFFECTS"})
        if (const std::string value = environment(name); !value.empty())
            words.push_back(std::string(name) + "=" + value);
    std::error_code ignored;
    words.push_back(std::filesystem::read_symlink("/proc/self/exe", ignored).string());
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    words.push_back(std::string("--gtest_filter=") + test->test_suite_name() + "." + test->name());
    return rig::shellCommand(words);
}

}  // namespace

Image imageOf(const Picture& picture) {
    Image image = blankImage(picture.width, picture.height, 4);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = picture.pixels[i / 4][i % 4];
    return image;
}

Image imageOf(const std::vector<Allowed>& allowed, int width, int height) {
    Image image = blankImage(width, height, 4);
    for (std::size_t i = 0; i < image.values.size(); ++i)
        image.values[i] = static_cast<float>(allowed[i / 4][i % 4].mid());
    return image;
}

void judge(const Permutation& permutation, const std::string& check, const std::string& reason, const Image& image,
           const Image* expected) {
    const rig::Subject subject{permutation.effect(), permutation.name(), std::string(permutation.pass().name), check};
    Result<void> reported;
    if (reason.empty()) {
        reported = rig::reportPass(reportFolder(), subject);
    } else {
        ADD_FAILURE() << permutation.name() << ", " << check << ": " << reason;
        reported = rig::reportFailure(reportFolder(), {subject, permutation.constants(), reason, thisTestsCommand()},
                                      &image, expected);
    }
    EXPECT_TRUE(reported.has_value()) << reported.error().message;
}

void judgeGolden(const Permutation& permutation, const std::string& name, const Image& image,
                 rig::Tolerance tolerance) {
    rig::GoldenStore store;
    store.folder = TYNDALL_GOLDENS_FOLDER;
    store.update = environment("TYNDALL_UPDATE_GOLDENS") == "1";
    store.remedy = "run this test with TYNDALL_UPDATE_GOLDENS=1";
    const rig::GoldenVerdict verdict = rig::checkGolden(store, name, image, tolerance);
    judge(permutation, "golden " + name, verdict.reason, image, verdict.expected ? &*verdict.expected : nullptr);
}

void judgeOracle(const Permutation& permutation, const std::string& check, const Picture& picture, double scale,
                 const std::vector<Allowed>& allowed) {
    Image image = imageOf(picture);
    for (float& value : image.values) value = static_cast<float>(value / scale);
    const Image expected = imageOf(allowed, picture.width, picture.height);
    judge(permutation, check, whyOutside(picture, scale, allowed), image, &expected);
}

}  // namespace tyndall::test

// The rig on a broken slices.fx: it names the broken permutation, with its picture, and no other one. It runs the other
// test program on a build of the broken text.
#include <gtest/gtest.h>
#include <tyndall/terms.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "../rig/folder.h"
#include "../rig/process.h"

namespace tyndall::test {
namespace {

const std::string kSlices = readText(SHADERS "/slices.fx");

struct BrokenPermutation : testing::Test {
    Folder folder;
    std::string report = folder.at("report");

    Ran tryOut(const std::string& text, const std::string& tests) {
        compileEffect(folder.path(), "slices", text, {"-I", SHADERS});
        return runProgram({"env", "TYNDALL_EFFECTS=" + folder.at("out"), "TYNDALL_REPORT=" + report, PERMUTATION_TEST,
                           "--gtest_filter=" + tests});
    }
    /// The techniques in the report that failed a check whose name begins with `check`. Each has its pictures.
    std::set<std::string> blamed(const std::string& check) {
        std::set<std::string> techniques;
        const std::string page = readText(report + "/index.html");
        for (const auto& at : std::filesystem::directory_iterator(report + "/entries")) {
            const auto json = nlohmann::json::parse(readText(at.path() / "entry.json"));
            if (!json["check"].get<std::string>().starts_with(check)) continue;
            const std::string technique = json["technique"];
            techniques.insert(technique);
            EXPECT_EQ(json["pictures"], nlohmann::json({"image", "expected", "difference"})) << technique;
            for (const char* picture : {"image", "expected", "difference"}) {
                EXPECT_GT(readText(at.path() / (picture + std::string(".png"))).size(), 100u) << technique;
                EXPECT_TRUE(std::filesystem::exists(at.path() / (picture + std::string(".exr")))) << technique;
            }
            EXPECT_NE(page.find("<h2>" + technique + "</h2>"), std::string::npos);
            EXPECT_NE(json["command"].get<std::string>().find("TYNDALL_EFFECTS="), std::string::npos);
        }
        return techniques;
    }
};

using Names = std::set<std::string>;

TEST_F(BrokenPermutation, NothingIsBlamedWhereNothingIsBroken) {
    const Ran ran = tryOut(kSlices, "*GoldenTest*:*MaskTest*:*SpecializationTest*");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_FALSE(std::filesystem::exists(report));
}

TEST_F(BrokenPermutation, AWrongSwitchIsBlamedOnItsTechniqueByEveryTier) {
    const std::string broken = "clip_nonoise_shadow_cookie_technique";
    const std::regex declared(broken + R"(,\s*false,\s*true,\s*true,)");
    const std::string text = std::regex_replace(kSlices, declared, broken + ", false, true, false,");
    ASSERT_NE(text, kSlices);
    const Ran ran = tryOut(text, "*GoldenTest*:*MaskTest*:*LiveTest*:*SpirvTest*:*TechniqueTest*" + broken + "*");
    EXPECT_EQ(ran.status, 1) << ran.text;
    EXPECT_EQ(blamed("golden"), Names{broken});
    EXPECT_EQ(blamed("mask of cookie"), Names{broken});
    EXPECT_EQ(blamed("oracle"), Names{broken});
    EXPECT_NE(ran.text.find("[  FAILED  ] SlicesFx/LiveTest.ExactlyTheUniformBlockAndTheSamplersItsSwitchesCallFor/" +
                            broken),
              std::string::npos);
    EXPECT_NE(ran.text.find("[  FAILED  ] SlicesFx/SpirvTest.ItsSwitchesAreWhatItsNameSays/" + broken),
              std::string::npos);
}

TEST_F(BrokenPermutation, AFaultInOneTermIsBlamedOnTheTechniquesThatHaveItAndOnThatMask) {
    const Ran ran = tryOut(replaced(kSlices, "cookie = project(CookieSampler, tcProj).rgb;",
                                    "cookie = project(CookieSampler, tcProj * float4(1.01, 1.0, 1.0, 1.0)).rgb;"),
                           "*GoldenTest*:*MaskTest*");
    EXPECT_EQ(ran.status, 1) << ran.text;
    Names withCookie;
    for (const TermSet terms : allTermSets)
        if (terms.contains(Term::Cookie)) withCookie.insert(std::string(techniqueName(terms)));
    EXPECT_EQ(blamed("golden"), withCookie);
    EXPECT_EQ(blamed("mask of cookie"), withCookie);
    EXPECT_EQ(blamed("mask of shadow"), Names{});
    EXPECT_EQ(blamed("mask of noise"), Names{});
}

/// slices.fx with one more switch, off in the existing techniques and on in two new ones; and with one more technique
/// that repeats another.
std::string withAnAxisMore() {
    std::string text = replaced(kSlices, "uniform bool bScattering) : COLOR0",
                                "uniform bool bScattering, uniform bool bRed) : COLOR0");
    text = replaced(text, "    return ChannelMask *", "    if (bRed) colour.gb *= 0.25;\n    return ChannelMask *");
    text =
        replaced(text, "ps_main(noise, shadow, cookie, scattering)", "ps_main(noise, shadow, cookie, scattering, RED)");
    return replaced(text, "#define SLICE_TECHNIQUE", "#define RED false\n#define SLICE_TECHNIQUE") +
           "SLICE_TECHNIQUE(added_technique, true, true, true, true)\n#undef RED\n#define RED true\n"
           "SLICE_TECHNIQUE(added_red_technique, true, true, true, true)\n"
           "SLICE_TECHNIQUE(added_plain_red_technique, false, false, false, false)\n";
}

// The tests try everything that the effect declares, without changes: new techniques lack their goldens, and nothing
// fails in any other way. The slowest suite, against the integral, is left out. So are the existing techniques with
// scattering, because the others show the same in half the time.
TEST_F(BrokenPermutation, ANewAxisIsTriedAndLacksItsGoldensAndNothingElse) {
    const Ran ran = tryOut(withAnAxisMore(), "*-*ReferenceTest*:*_scattering_technique*");
    EXPECT_EQ(ran.status, 1) << ran.text;
    for (const std::string added : {"added_technique", "added_red_technique", "added_plain_red_technique"}) {
        EXPECT_NE(ran.text.find(added + ", golden " + added + ".physical: there is no golden"), std::string::npos)
            << ran.text;
        for (const std::string test : {"SpecializationTest.DrawsTheSameTwice", "LiveTest.OnlyLiveResourcesAreBound"})
            EXPECT_NE(ran.text.find("[       OK ] SlicesFx/" + test + "/" + added), std::string::npos) << added;
    }
    const std::string oracle = "[       OK ] SlicesFx/TechniqueTest.BothGeometriesMatchTheOracleAndEachOther/";
    EXPECT_NE(ran.text.find(oracle + "added_technique"), std::string::npos);
    EXPECT_EQ(ran.text.find(oracle + "added_red_technique"), std::string::npos);

    const std::string failed = "[  FAILED  ] ";
    int failures = 0;
    for (std::size_t at = ran.text.find(failed); at != std::string::npos; at = ran.text.find(failed, at + 1)) {
        const std::string line = ran.text.substr(at, ran.text.find('\n', at) - at);
        if (line.find(" tests, listed below") != std::string::npos) continue;
        ++failures;
        EXPECT_NE(line.find("SlicesFx/GoldenTest."), std::string::npos) << line;
        EXPECT_NE(line.find("/added_"), std::string::npos) << line;
    }
    EXPECT_EQ(failures, 2 * 3 * 3);  // each is said when it fails and when all is done
}

}  // namespace
}  // namespace tyndall::test

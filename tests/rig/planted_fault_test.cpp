// Mutations of the example effect, one at a time: the rig names the technique and the pass, shows the picture, and
// fails no other technique.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "folder.h"
#include "process.h"

namespace tyndall::test {
namespace {

const std::string kCelEffect = EXAMPLE "/cel.fx", kCelFixture = EXAMPLE "/cel.rig.json",
                  kCelGoldens = EXAMPLE "/goldens";

struct PlantedFault : testing::Test {
    Folder folder;
    std::string report = folder.at("report");

    Ran tryOut(const std::string& manifest) {
        return runProgram({PERMGEN_RIG, manifest, kCelFixture, "--goldens", kCelGoldens, "--report", report});
    }
    Ran tryOutWith(const std::string& from, const std::string& to) {
        return tryOut(compileEffect(folder.path(), "cel", replaced(readText(kCelEffect), from, to)));
    }
    /// The report's entry of that technique, pass and check.
    nlohmann::json entry(const std::string& technique, const std::string& pass, const std::string& check) {
        for (const auto& at : std::filesystem::directory_iterator(report + "/entries")) {
            const auto json = nlohmann::json::parse(readText(at.path() / "entry.json"));
            if (json["technique"] != technique || json["pass"] != pass || json["check"] != check) continue;
            EXPECT_NE(readText(report + "/index.html").find("id=\"" + at.path().filename().string()),
                      std::string::npos);
            for (const auto& picture : json["pictures"])
                EXPECT_GT(readText(at.path() / (picture.get<std::string>() + ".png")).size(), 100u);
            return json;
        }
        ADD_FAILURE() << "the report has no entry " << technique << ", " << pass << ", " << check;
        return {};
    }
};

std::string verdicts(const std::string& text) {
    std::string lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (line.starts_with("ok ") || line.starts_with("FAIL ")) lines += line.substr(0, line.find(':')) + "\n";
        at = end + 1;
    }
    return lines;
}

TEST_F(PlantedFault, NoneIsFoundWhereThereIsNone) {
    const Ran ran = tryOut(compileEffect(folder.path(), "cel", readText(kCelEffect)));
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_EQ(verdicts(ran.text),
              "ok    smooth\nok    three_bands\nok    five_bands_paper\nok    drawing\nok    drawing_crossed\n");
    EXPECT_EQ(ran.text.find("note:"), std::string::npos) << ran.text;
    EXPECT_FALSE(std::filesystem::exists(report));
}

TEST_F(PlantedFault, AWrongIntSwitchInOneTechnique) {
    const Ran ran = tryOutWith("three_bands      { PAINT(3, 0.96, false) }", "three_bands { PAINT(4, 0.96, false) }");
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(verdicts(ran.text),
              "ok    smooth\nFAIL  three_bands\nok    five_bands_paper\nok    drawing\nok    drawing_crossed\n");
    EXPECT_NE(ran.text.find("three_bands, pass paint: golden: "), std::string::npos) << ran.text;
    const auto json = entry("three_bands", "paint", "golden");
    EXPECT_EQ(json["pictures"], nlohmann::json({"image", "expected", "difference"}));
    EXPECT_EQ(json["constants"]["nBands"], "4");
    EXPECT_GT(json["figures"]["largest_difference"], 0.01);
    EXPECT_NE(json["command"].get<std::string>().find("--technique three_bands"), std::string::npos);
}

TEST_F(PlantedFault, AWrongFloatSwitchInTheSecondPass) {
    const Ran ran = tryOutWith("PENCIL(0.6, false)", "PENCIL(0.61, false)");
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(verdicts(ran.text),
              "ok    smooth\nok    three_bands\nok    five_bands_paper\nFAIL  drawing\nok    drawing_crossed\n");
    EXPECT_NE(ran.text.find("drawing, pass pencil: golden: "), std::string::npos) << ran.text;
    EXPECT_EQ(ran.text.find("drawing, pass paint:"), std::string::npos) << ran.text;
    entry("drawing", "pencil", "golden");
}

TEST_F(PlantedFault, AWrongBlendStateInTheSecondPass) {
    const Ran ran = tryOutWith("SrcBlend = ZERO; DestBlend = SRCCOLOR;", "SrcBlend = ONE; DestBlend = ZERO;");
    EXPECT_EQ(verdicts(ran.text),
              "ok    smooth\nok    three_bands\nok    five_bands_paper\nFAIL  drawing\nFAIL  drawing_crossed\n");
    entry("drawing_crossed", "pencil", "golden");
}

TEST_F(PlantedFault, NanInOnePermutation) {
    const Ran ran = tryOutWith("colour *= 0.7 + 0.3 * tex2D", "colour *= sqrt(light - 0.5) * tex2D");
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(verdicts(ran.text),
              "ok    smooth\nok    three_bands\nFAIL  five_bands_paper\nFAIL  drawing\nok    drawing_crossed\n");
    EXPECT_NE(ran.text.find("five_bands_paper, pass paint: finite: "), std::string::npos) << ran.text;
    EXPECT_GT(entry("five_bands_paper", "paint", "finite")["figures"]["nan"], 0);
}

/// The path of a frozen pixel module, beside the manifest.
std::string frozenPixel(const std::string& manifest, std::size_t technique) {
    const auto json = nlohmann::json::parse(readText(manifest));
    const std::string file = json["techniques"][technique]["passes"][0]["pixel"]["frozen"];
    return (std::filesystem::path(manifest).parent_path() / file).string();
}

TEST_F(PlantedFault, AFrozenModuleThatIsAnotherTechniques) {
    const std::string manifest = compileEffect(folder.path(), "cel", readText(kCelEffect));
    writeText(frozenPixel(manifest, 0), readText(frozenPixel(manifest, 1)));
    const Ran ran = tryOut(manifest);
    EXPECT_EQ(ran.status, 1);
    EXPECT_NE(ran.text.find("smooth, pass paint: specialized against frozen: "), std::string::npos) << ran.text;
    entry("smooth", "paint", "specialized against frozen");
}

TEST_F(PlantedFault, AResourceThatIsSaidToBeDeadAndIsNot) {
    const std::string manifest = compileEffect(folder.path(), "cel", readText(kCelEffect));
    // five_bands_paper without its paper, in the list and in the frozen module; the switches still select it.
    auto json = nlohmann::ordered_json::parse(readText(manifest));
    json["techniques"][2]["passes"][0]["live"] = {"Globals"};
    writeText(frozenPixel(manifest, 2), readText(frozenPixel(manifest, 0)));
    writeText(manifest, json.dump(2));
    const Ran ran = tryOut(manifest);
    EXPECT_EQ(ran.status, 1);
    EXPECT_NE(ran.text.find("five_bands_paper: liveness of PaperSampler: PaperSampler is not live, but another"),
              std::string::npos)
        << ran.text;
    entry("five_bands_paper", "", "liveness of PaperSampler");
}

TEST_F(PlantedFault, AModuleThatReadsWhatIsNotBoundIsHeardOfFromValidation) {
    const std::string manifest = compileEffect(folder.path(), "cel", readText(kCelEffect));
    auto json = nlohmann::ordered_json::parse(readText(manifest));
    json["techniques"][2]["passes"][0]["live"] = {"Globals"};
    writeText(manifest, json.dump(2));
    const Ran ran = tryOut(manifest);
    EXPECT_EQ(ran.status, 1) << ran.text;
    EXPECT_NE(ran.text.find("five_bands_paper, pass paint: drawn, frozen: "), std::string::npos) << ran.text;
    EXPECT_NE(ran.text.find("VUID-"), std::string::npos) << ran.text;
}

TEST_F(PlantedFault, APassThatIsWholeAgainTakesItsEntryAway) {
    EXPECT_EQ(tryOutWith("PENCIL(0.6, false)", "PENCIL(0.61, false)").status, 1);
    EXPECT_EQ(tryOut(compileEffect(folder.path(), "cel", readText(kCelEffect))).status, 0);
    EXPECT_TRUE(std::filesystem::is_empty(report + "/entries"));
    EXPECT_NE(readText(report + "/index.html").find("Nothing fails"), std::string::npos);
}

}  // namespace
}  // namespace tyndall::test

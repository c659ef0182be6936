#include "emit/emit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "back/build_program.h"
#include "emit/list_effect.h"
#include "emit/namespace_name.h"
#include "small_effect.h"

namespace permgen {
namespace {

Program built(Lowered effect, int jobs = 2) {
    Diagnostics diagnostics;
    BuildOptions options;
    options.jobs = jobs;
    auto program = build_program(std::move(effect), options, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics) ADD_FAILURE() << format(diagnostic);
    return program ? std::move(*program) : Program{};
}

const Program& small() {
    static const Program program = built(test::small_effect());
    return program;
}

std::vector<std::string> names(const std::vector<OutputFile>& files) {
    std::vector<std::string> all;
    for (const OutputFile& file : files) all.push_back(file.path);
    return all;
}

TEST(Emit, OneFileAModuleAManifestAndAHeader) {
    EXPECT_EQ(names(emit_files(small(), {"small", false})),
              (std::vector<std::string>{"small.vs_main.spv", "small.ps_main.spv", "small.fx.json", "small.fx.h"}));
}

TEST(Emit, FreezeAddsEveryPassesStages) {
    EXPECT_EQ(names(emit_files(small(), {"small", true})),
              (std::vector<std::string>{"small.vs_main.spv", "small.ps_main.spv", "small.plain.0-p0.vertex.spv",
                                        "small.plain.0-p0.pixel.spv", "small.patterned.0-p0.vertex.spv",
                                        "small.patterned.0-p0.pixel.spv", "small.fx.json", "small.fx.h"}));
}

TEST(Emit, SameBytesWhateverTheNumberOfJobs) {
    const auto first = emit_files(small(), {"small", true});
    for (const int jobs : {1, 8}) {
        const auto again = emit_files(built(test::small_effect(), jobs), {"small", true});
        ASSERT_EQ(names(first), names(again));
        for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].bytes, again[i].bytes) << first[i].path;
    }
}

TEST(Emit, SpirvIsLittleEndian) {
    EXPECT_EQ(spirv_bytes({0x07230203u}), std::string("\x03\x02\x23\x07"));
}

TEST(Emit, AFileNameHoldsNothingThatLeadsElsewhere) {
    Program program = small();
    program.effect.name = "a/../b c";
    EXPECT_EQ(module_file(program, 0), "a____b_c.vs_main.spv");
}

TEST(Manifest, SaysWhatTheEffectIs) {
    const auto json = nlohmann::json::parse(emit_manifest(small(), {"small", true}));
    EXPECT_EQ(json["effect"], "small");
    EXPECT_EQ(json["modules"].size(), 2u);
    EXPECT_EQ(json["modules"][1]["file"], "small.ps_main.spv");
    EXPECT_EQ(json["modules"][1]["axes"][1]["name"], "bCookie");
    EXPECT_EQ(json["modules"][1]["axes"][1]["default"], false);
    EXPECT_EQ(json["modules"][0]["attributes"][0]["semantic"], "POSITION0");
    EXPECT_EQ(json["modules"][0]["attributes"][0]["components"], 3);
    EXPECT_EQ(json["resources"][0]["size"], 112);
    EXPECT_EQ(json["resources"][1]["dimension"], "2d");
    EXPECT_EQ(json["resources"][1]["sampler_states"][0]["value"], "LINEAR");
    EXPECT_EQ(json["members"][1]["offset"], 64);
    EXPECT_EQ(json["members"][1]["size"], 32);
    const auto& pass = json["techniques"][1]["passes"][0];
    EXPECT_EQ(pass["pixel"]["frozen"], "small.patterned.0-p0.pixel.spv");
    EXPECT_EQ(pass["pixel"]["constants"][1]["value"], true);
    EXPECT_EQ(pass["live"], nlohmann::json({"Globals", "CookieSampler"}));
    EXPECT_EQ(pass["states"][0]["name"], "SrcBlend");
    EXPECT_EQ(pass["states"][0]["state"], "SrcBlend");
    EXPECT_EQ(pass["states"][0]["kind"], "enum");
    EXPECT_EQ(pass["states"][0]["bits"], 2);
    EXPECT_EQ(pass["states"][0]["index"], 0);
}

TEST(Manifest, NoFrozenFilesWithoutFreeze) {
    EXPECT_EQ(emit_manifest(small(), {"small", false}).find("frozen"), std::string::npos);
}

TEST(List, HasTheDocumentedForm) {
    const auto json = nlohmann::json::parse(list_json(small()));
    EXPECT_EQ(json, nlohmann::json::parse(R"({"effect": "small", "techniques": [
        {"name": "plain", "passes": [{"name": "p0",
          "vertex": {"entry": "vs_main", "module": "vs_main", "constants": {}},
          "pixel": {"entry": "ps_main", "module": "ps_main", "constants": {"bNoise": false, "bCookie": false}},
          "live": ["Globals"], "states": {"SrcBlend": "ONE", "DestBlend": "ONE"}}]},
        {"name": "patterned", "passes": [{"name": "p0",
          "vertex": {"entry": "vs_main", "module": "vs_main", "constants": {}},
          "pixel": {"entry": "ps_main", "module": "ps_main", "constants": {"bNoise": false, "bCookie": true}},
          "live": ["Globals", "CookieSampler"], "states": {"SrcBlend": "ONE", "DestBlend": "ONE"}}]}]})"));
}

TEST(List, NumbersKeepTheirType) {
    Program program = small();
    auto& constants = program.effect.techniques[0].passes[0].pixel.constants;
    constants = {{"i", 0, ScalarType::Int, 0xfffffffeu},
                 {"u", 1, ScalarType::Uint, 0xfffffffeu},
                 {"f", 2, ScalarType::Float, 0x3fc00000u}};
    const auto json = nlohmann::json::parse(list_json(program));
    EXPECT_EQ(json["techniques"][0]["passes"][0]["pixel"]["constants"],
              nlohmann::json::parse(R"({"i": -2, "u": 4294967294, "f": 1.5})"));
}

TEST(List, AMissingStageIsNull) {
    Program program = small();
    program.effect.techniques[0].passes[0].vertex.module = -1;
    EXPECT_TRUE(nlohmann::json::parse(list_json(program))["techniques"][0]["passes"][0]["vertex"].is_null());
    EXPECT_NE(emit_header(program, {"small", false}).find("{nullptr, {}, {}}"), std::string::npos);
}

TEST(List, TheTableHasALineAPass) {
    EXPECT_EQ(list_table(small()),
              "small: 2 techniques over 2 modules\n"
              "technique  pass  vertex     pixel                  live\n"
              "plain      p0    vs_main()  ps_main(false, false)  Globals\n"
              "patterned  p0    vs_main()  ps_main(false, true)   Globals, CookieSampler\n");
}

TEST(Header, StatesAreTypedAndStringsEscaped) {
    Program program = small();
    program.effect.techniques[0].passes[0].states = {{"ColorOp[1]",
                                                      "a\"b\\c\n\xc3\xa4"
                                                      "9",
                                                      StateId::ColorOp, 1, ValueKind::Enum, 7}};
    EXPECT_NE(emit_header(program, {"small", false})
                  .find(R"({"ColorOp[1]", "a\"b\\c\012\303\2449", )"
                        "permgen::StateId::ColorOp, 1u, permgen::ValueKind::Enum, 0x7u},"),
              std::string::npos);
}

TEST(Header, AFrozenModuleThatPassesShareIsThereOnce) {
    const std::string header = emit_header(small(), {"small", true});
    EXPECT_NE(header.find("frozen_2[]"), std::string::npos) << "one vertex module, two pixel modules";
    EXPECT_EQ(header.find("frozen_3[]"), std::string::npos);
}

TEST(Keys, ATechniqueNamedLikeAKeywordStaysApartFromItsNeighbour) {
    Program program = small();
    program.effect.techniques[0].name = "new";
    program.effect.techniques[1].name = "new_";
    EXPECT_NE(emit_keys(program).find("    new__,\n    new_,\n"), std::string::npos) << emit_keys(program);
}

TEST(Keys, OneFunctionCompiledForBothStagesHasTwoKeys) {
    Program program = small();
    program.effect.modules[0].author_entry = program.effect.modules[1].author_entry = "both";
    program.effect.modules[0].name = "both";
    program.effect.modules[1].name = "both_2";  // as lowering names a second module of an entry point
    program.effect.modules[0].axes = program.effect.modules[1].axes;
    const std::string text = emit_keys(program);
    EXPECT_NE(text.find("struct both_key {"), std::string::npos);
    EXPECT_NE(text.find("struct both_2_key {"), std::string::npos);
}

TEST(Keys, AnAxisNamedLikeItsKeyIsRenamed) {
    Program program = small();
    program.effect.modules[1].axes[0].name = "ps_main_key";
    program.effect.modules[1].axes[1].name = "class";
    const std::string text = emit_keys(program);
    EXPECT_NE(text.find("bool ps_main_key_ = false;"), std::string::npos) << text;
    EXPECT_NE(text.find("bool class_ = false;"), std::string::npos) << text;
}

TEST(Depfile, EscapesWhatMakeWouldTakeApart) {
    EXPECT_EQ(emit_depfile("out dir/a.fx.h", {"b$c.fx", "d#e.fxh"}),
              "out\\ dir/a.fx.h: \\\n  b$$c.fx \\\n  d\\#e.fxh\n");
}

TEST(Namespace, OfAnEffect) {
    EXPECT_EQ(default_namespace("slices"), "slices");
    EXPECT_EQ(default_namespace("my-effect.v2"), "my_effect_v2");
    EXPECT_EQ(default_namespace("3d noise"), "effect_3d_noise");
    EXPECT_EQ(default_namespace("__x__y_"), "x_y");
    EXPECT_EQ(default_namespace("class"), "class_effect");
    EXPECT_EQ(default_namespace("permgen"), "permgen_effect");
    EXPECT_EQ(default_namespace("\xc3\xa4"), "effect");
    for (const char* name : {"slices", "my-effect.v2", "3d noise", "__x__y_", "class", "permgen", "\xc3\xa4", ""})
        EXPECT_TRUE(is_namespace(default_namespace(name))) << name;
}

TEST(Namespace, OfACommandLine) {
    for (const char* good : {"a", "studio::slices", "a1_b::c"}) EXPECT_TRUE(is_namespace(good)) << good;
    for (const char* bad : {"", "::a", "a::", "a:b", "a b", "1a", "_a", "a__b", "int", "a::std", "a;b"})
        EXPECT_FALSE(is_namespace(bad)) << bad;
}

}  // namespace
}  // namespace permgen

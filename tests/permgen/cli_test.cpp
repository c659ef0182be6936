// The complete program: its exit status, files and messages for a command line.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "back/validate.h"
#include "declared_techniques.h"

namespace permgen {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::uint32_t> read_words(const fs::path& path) {
    const std::string bytes = read(path);
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), words.size() * 4);
    return words;
}

struct Output {
    int status;  ///< -1: a signal ended it
    std::string out;
    std::string err;
};

class Cli : public testing::Test {
protected:
    Cli() {
        std::string pattern = testing::TempDir() + "permgen_cli_XXXXXX";
        folder = ::mkdtemp(pattern.data());
    }
    ~Cli() override { fs::remove_all(folder); }

    /// Runs `permgen ARGUMENTS` with the shell in `folder`, after `before`.
    Output permgen(const std::string& arguments, const std::string& before = {},
                   const std::string& standard_output = ".out") const {
        const std::string command = "cd '" + folder.string() + "' && " + before + " '" PERMGEN_PROGRAM "' " +
                                    arguments + " >" + standard_output + " 2>.err </dev/null";
        const int ended = std::system(command.c_str());
        Output outcome{WIFEXITED(ended) ? WEXITSTATUS(ended) : -1, read(folder / ".out"), read(folder / ".err")};
        fs::remove(folder / ".out");
        fs::remove(folder / ".err");
        return outcome;
    }

    void put(const std::string& name, const std::string& text) const {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << text;
    }

    /// Every file below `folder / where` with its bytes.
    std::map<std::string, std::string> files(const std::string& where = ".") const {
        std::map<std::string, std::string> all;
        if (fs::is_directory(folder / where))
            for (const auto& entry : fs::recursive_directory_iterator(folder / where))
                if (entry.is_regular_file())
                    all[fs::relative(entry.path(), folder / where).string()] = read(entry.path());
        return all;
    }

    fs::path folder;
};

constexpr const char* slices = SHADERS "/slices.fx";

// Small enough to vary: one vertex shader that feeds one pixel shader.
constexpr const char* good = R"(float4x4 gClipFromView;
sampler2D Map;
struct Point { float4 position : POSITION; float2 uv : TEXCOORD0; };
Point vs_main(float3 p : POSITION, float2 uv : TEXCOORD0)
{
    Point o;
    o.position = mul(gClipFromView, float4(p, 1.0));
    o.uv = uv;
    return o;
}
float4 ps_main(float2 uv : TEXCOORD0, uniform bool bMap) : COLOR
{
    return bMap ? tex2D(Map, uv) : float4(uv, 0.0, 1.0);
}
technique flat { pass p0 { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_main(false); } }
technique mapped { pass p0 { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_main(true); } }
)";

std::string with(const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

constexpr const char* compute = R"(RWTexture2D<float> image;
[numthreads(8, 4, 2)]
void cs_main(uint3 id : SV_DispatchThreadID, uniform bool ramp) { image[id.xy] = ramp ? id.x : 1; }
technique t { pass p { ComputeShader = compile cs_5_0 cs_main(true); } }
)";

TEST_F(Cli, CompilesComputeShaders) {
    put("compute.fx", compute);
    const Output outcome = permgen("compile --freeze -o out compute.fx");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(read(folder / "out/compute.fx.h").find("{8u, 4u, 2u}"), std::string::npos);
    const auto manifest = nlohmann::json::parse(read(folder / "out/compute.fx.json"));
    EXPECT_EQ(manifest["modules"][0]["group_size"], nlohmann::json({8, 4, 2}));
    EXPECT_EQ(manifest["resources"][0]["format"], "r32f");
    for (const char* file : {"out/compute.cs_main.spv", "out/compute.t.0-p.compute.spv"})
        EXPECT_EQ(validate_spirv(read_words(folder / file)), "") << file;
    const std::string table = permgen("list compute.fx").out;
    EXPECT_NE(table.find("cs_main(true) [8, 4, 2]"), std::string::npos) << table;
    const auto list = nlohmann::json::parse(permgen("list --json compute.fx").out);
    EXPECT_EQ(list["techniques"][0]["passes"][0]["compute"]["group_size"], nlohmann::json({8, 4, 2}));
}

TEST_F(Cli, AComputeShaderWithoutAGroupIsReportedAtItsPlace) {
    std::string text = compute;
    text.replace(text.find("[numthreads(8, 4, 2)]"), 21, "");
    put("compute.fx", text);
    const Output outcome = permgen("compile -o out compute.fx");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err.rfind("compute.fx:3:6: error[PG029]: compute shader 'cs_main' has no thread group", 0), 0u)
        << outcome.err;
    EXPECT_TRUE(files("out").empty());
}

TEST_F(Cli, ListsEveryTechniqueOverOnePixelModule) {
    const Output outcome = permgen(std::string("list --json ") + slices);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["effect"], "slices");
    const std::vector<DeclaredTechnique> declared = declared_techniques(slices);
    ASSERT_GE(declared.size(), 16u);
    ASSERT_EQ(json["techniques"].size(), declared.size());
    const std::map<std::string, std::string> samplers = {{"bScrollingNoise", "ScrollingNoiseSampler"},
                                                         {"bShadowMapping", "ShadowMapSampler"},
                                                         {"bCookie", "CookieSampler"}};
    for (std::size_t i = 0; i < declared.size(); ++i) {
        const auto& technique = json["techniques"][i];
        EXPECT_EQ(technique["name"], declared[i].name);
        ASSERT_EQ(technique["passes"].size(), 1u);
        const auto& pass = technique["passes"][0];
        EXPECT_EQ(pass["vertex"]["module"], "vs_main");
        EXPECT_EQ(pass["pixel"]["module"], "ps_main");
        EXPECT_EQ(pass["pixel"]["entry"], "ps_main");
        nlohmann::json constants = nlohmann::json::object();
        std::set<std::string> live = {"Globals"};
        for (const auto& [axis, on] : declared[i].switches) {
            constants[axis] = on;
            if (const auto sampler = samplers.find(axis); on && sampler != samplers.end()) live.insert(sampler->second);
        }
        EXPECT_EQ(pass["pixel"]["constants"], constants);
        EXPECT_EQ(pass["live"].get<std::set<std::string>>(), live) << technique["name"];
        EXPECT_EQ(pass["states"]["DestBlend"], "ONE");
    }
}

TEST_F(Cli, SameBytesWhateverTheJobsTheFolderOrTheSecondTime) {
    ASSERT_EQ(permgen(std::string("compile --freeze --jobs 1 -o a ") + slices).status, 0);
    const auto first = files("a");
    const std::size_t stages = 2 * declared_techniques(slices).size();
    EXPECT_EQ(first.size(), 2 + stages + 2);  // modules, frozen stages, manifest and header
    for (const char* options : {"--jobs 2 -o b", "--jobs 8 -o deep/er", "--jobs 2 -o a"}) {
        ASSERT_EQ(permgen(std::string("compile --freeze ") + options + " " + slices).status, 0);
        EXPECT_EQ(files(std::strrchr(options, ' ') + 1), first) << options;
    }
    fs::copy_file(slices, folder / "slices.fx");
    fs::copy_file(SHADERS "/shadow.fxh", folder / "shadow.fxh");
    ASSERT_EQ(permgen("compile --freeze -o c slices.fx").status, 0);
    EXPECT_EQ(files("c"), first) << "the same effect by another path";
}

TEST_F(Cli, EveryModuleIsValid) {
    ASSERT_EQ(permgen(std::string("compile --freeze -o a ") + slices).status, 0);
    for (const auto& [name, bytes] : files("a"))
        if (name.ends_with(".spv")) {
            EXPECT_EQ(validate_spirv(read_words(folder / "a" / name)), "") << name;
        }
}

TEST_F(Cli, AnUnchangedFileKeepsItsTime) {
    put("good.fx", good);
    ASSERT_EQ(permgen("compile -o a good.fx").status, 0);
    const auto before = fs::last_write_time(folder / "a/good.fx.h") - std::chrono::hours(1);
    fs::last_write_time(folder / "a/good.fx.h", before);
    ASSERT_EQ(permgen("compile -o a good.fx").status, 0);
    EXPECT_EQ(fs::last_write_time(folder / "a/good.fx.h"), before);
}

TEST_F(Cli, TheDepfileNamesEveryFileRead) {
    put("in clude/tint.fxh", "#define TINT 0.5\n");
    put("good.fx", "#include \"tint.fxh\"\n" + with("0.0, 1.0", "TINT, 1.0"));
    const Output outcome = permgen("compile -I 'in clude' --depfile a/d -o a good.fx");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(read(folder / "a/d"), "a/good.fx.h: \\\n  good.fx \\\n  in\\ clude/tint.fxh\n");
}

TEST_F(Cli, DefinitionsReachTheEffect) {
    put("good.fx", with("0.0, 1.0", "DEPTH, ONE"));
    EXPECT_EQ(permgen("list good.fx").status, 1);
    EXPECT_EQ(permgen("list -D DEPTH=0.25 -D ONE good.fx").status, 0);
}

// glslang reserves these words; the tables hold them as the author wrote them.
TEST_F(Cli, NamesThatGlslangReservesComeOutAsWritten) {
    put("words.fx",
        "float4 point;\nsampler2D line;\n"
        "float4 vs_main(float4 position : POSITION) : POSITION { return position + point; }\n"
        "float4 ps_main(uniform bool triangle) : COLOR0\n"
        "{ float4 c = point; if (triangle) c = tex2D(line, c.xy); return c; }\n"
        "technique t { pass { VertexShader = compile vs_2_0 vs_main(); PixelShader = compile ps_2_0 ps_main(true); } "
        "}\n");
    const Output outcome = permgen("compile words.fx -o out");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto manifest = nlohmann::json::parse(read(folder / "out/words.fx.json"));
    EXPECT_EQ(manifest.dump().find("permgen_id"), std::string::npos) << manifest.dump(2);
    EXPECT_NE(manifest.dump().find("\"name\":\"point\""), std::string::npos) << manifest.dump(2);
}

TEST_F(Cli, TheNamespaceIsTheOneAskedFor) {
    put("my-effect.fx", good);
    ASSERT_EQ(permgen("compile -o a my-effect.fx").status, 0);
    EXPECT_NE(read(folder / "a/my-effect.fx.h").find("namespace my_effect {"), std::string::npos);
    ASSERT_EQ(permgen("compile --namespace studio::fx -o a my-effect.fx").status, 0);
    EXPECT_NE(read(folder / "a/my-effect.fx.h").find("namespace studio::fx {"), std::string::npos);
}

struct Wrong {
    const char* name;
    const char* from;
    const char* to;
    const char* says;  ///< regular expression for standard error
};
void PrintTo(const Wrong& wrong, std::ostream* out) {
    *out << wrong.name;
}

class WrongEffect : public Cli, public testing::WithParamInterface<Wrong> {};

TEST_P(WrongEffect, IsToldAndWritesNothing) {
    put("good.fx", good);
    ASSERT_EQ(permgen("compile -o a good.fx").status, 0);
    const auto before = files("a");
    put("good.fx", with(GetParam().from, GetParam().to));
    const Output outcome = permgen("compile -o a good.fx");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(std::regex_search(outcome.err, std::regex(GetParam().says))) << outcome.err;
    EXPECT_EQ(files("a"), before);
}

INSTANTIATE_TEST_SUITE_P(
    Cli, WrongEffect,
    testing::Values(
        Wrong{"MisspeltEntryPoint", "compile ps_3_0 ps_main(true)", "compile ps_3_0 ps_mian(true)",
              "^good\\.fx:16:[0-9]+: error\\[PG0[0-9]+\\]: .*ps_mian"},
        Wrong{"TooFewArguments", "ps_main(true)", "ps_main()", "^good\\.fx:16:[0-9]+: error\\[PG0[0-9]+\\]: .*ps_main"},
        Wrong{"TooManyArguments", "ps_main(true)", "ps_main(true, false)",
              "^good\\.fx:16:[0-9]+: error\\[PG0[0-9]+\\]: .*ps_main"},
        Wrong{"MissingInclude", "sampler2D Map;", "#include \"nowhere.fxh\"\nsampler2D Map;",
              "^good\\.fx:2:[0-9]+: error\\[PG0[0-9]+\\]: .*nowhere\\.fxh"},
        Wrong{"MistypedState", "PixelShader", "AlphaBlendEnabel = TRUE; PixelShader",
              "error\\[PG043\\]: 'AlphaBlendEnabel' is not a state of Direct3D 9; did you mean 'AlphaBlendEnable'\\?\n"
              ".*AlphaBlendEnabel = TRUE;.*\n *\\^\n$"},
        Wrong{"UnknownName", "float4(uv, 0.0, 1.0)", "float4(uv, depth, 1.0)",
              "^good\\.fx:13:47: error\\[PG050\\]: 'depth': unknown variable\n"
              "    return bMap . tex2D\\(Map, uv\\) : float4\\(uv, depth, 1.0\\);\n {46}\\^\n$"},
        Wrong{"SyntaxError", "return o;", "return o",
              "^good\\.fx:10: error\\[PG050\\]: syntax error: expected ';' here or on the line before\n$"},
        Wrong{"CompilerCrash", "return bMap", "case 1: return bMap",
              "\ngood\\.fx:11:8: error\\[PG052\\]: entry point 'ps_main' .*crashed"},
        Wrong{"UnfedVarying", "float2 uv : TEXCOORD0; };", "float2 uv : TEXCOORD3; };",
              "^good\\.fx:15:[0-9]+: error\\[PG060\\]: 'ps_main' reads TEXCOORD0, but 'vs_main' writes only TEXCOORD3"},
        Wrong{"NarrowVarying", "float2 uv : TEXCOORD0, uniform", "float4 uv : TEXCOORD0, uniform",
              "error\\[PG0[0-9]+\\]"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(Cli, AMistakeInAnIncludedFileIsToldThere) {
    put("tint.fxh", "// one\nfloat tint(float x)\n{\n    return x * gLevel;\n}\n");
    put("good.fx", "#include \"tint.fxh\"\n" + with("0.0, 1.0", "tint(uv.x), 1.0"));
    const Output outcome = permgen("list good.fx");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err,
              "tint.fxh:4:16: error[PG050]: 'gLevel': unknown variable\n"
              "    return x * gLevel;\n"
              "               ^\n");
}

class WrongCommandLine : public Cli, public testing::WithParamInterface<const char*> {};

TEST_P(WrongCommandLine, IsStatusTwo) {
    put("good.fx", good);
    const auto before = files();
    const Output outcome = permgen(GetParam());
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
    EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(Cli, WrongCommandLine,
                         testing::Values("", "good.fx", "compile", "compile good.fx", "compile -o a", "list",
                                         "list good.fx -o a", "compile -o a good.fx more.fx",
                                         "compile -o a good.fx --jobs 0", "compile -o a good.fx --jobs many",
                                         "compile -o a good.fx --namespace 9", "compile -o a good.fx --namespace std",
                                         "compile -o a good.fx -D 9=1", "compile -o a good.fx -D =1",
                                         "compile -o a good.fx --frozen", "compile -o '' good.fx", "list ''"));

TEST_F(Cli, HelpAndVersionAreFine) {
    for (const char* arguments : {"--help", "compile --help", "list --help", "--version"}) {
        const Output outcome = permgen(arguments);
        EXPECT_EQ(outcome.status, 0) << arguments;
        EXPECT_NE(outcome.out.find("permgen"), std::string::npos) << arguments;
        EXPECT_EQ(outcome.err, "");
    }
}

TEST_F(Cli, AFileThatIsNotThere) {
    const Output outcome = permgen("compile -o a nowhere.fx");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.starts_with("nowhere.fx: error[PG0")) << outcome.err;
    EXPECT_TRUE(files().empty());
}

TEST_F(Cli, AnOutputFolderThatIsAFile) {
    put("good.fx", good);
    put("a", "mine");
    const auto before = files();
    const Output outcome = permgen("compile -o a good.fx");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "good.fx: error[PG070]: cannot write into 'a': it is not a folder; choose another\n");
    EXPECT_EQ(files(), before);
}

TEST_F(Cli, AnOutputFolderThatCannotBe) {
    put("good.fx", good);
    const Output outcome = permgen("compile -o /proc/permgen good.fx");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.starts_with("good.fx: error[PG070]: cannot make the folder '/proc/permgen'"))
        << outcome.err;
}

TEST_F(Cli, AFullDiskLeavesWhatWasThere) {
    put("good.fx", good);
    ASSERT_EQ(permgen("compile -o a good.fx").status, 0);
    const auto before = files();
    put("good.fx", with("0.0, 1.0", "0.5, 1.0"));
    const Output outcome = permgen("compile -o a good.fx", "ulimit -f 8 &&");  // blocks of 512 or 1024 bytes
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("error[PG070]: cannot write 'a/good.fx.h': File too large"), std::string::npos)
        << outcome.err;
    put("good.fx", good);
    EXPECT_EQ(files(), before);
}

TEST_F(Cli, TheDepfileDoesNotTakeTheEffectsPlace) {
    put("good.fx", good);
    const auto before = files();
    const Output outcome = permgen("compile -o . --depfile ./good.fx good.fx");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("the effect is made of this file"), std::string::npos) << outcome.err;
    EXPECT_EQ(files(), before);
}

TEST_F(Cli, TheDepfileDoesNotTakeTheHeadersPlace) {
    put("good.fx", good);
    const auto before = files();
    const Output outcome = permgen("compile -o a --depfile a/../a/good.fx.h good.fx");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("twice"), std::string::npos) << outcome.err;
    EXPECT_EQ(files(), before);
}

TEST_F(Cli, AFullStandardOutputIsAnError) {
    put("good.fx", good);
    const Output outcome = permgen("list good.fx", {}, "/dev/full");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "error[PG071]: the list could not be written to standard output\n");
}

}  // namespace
}  // namespace permgen

#include "front/preprocess.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace permgen {
namespace {

// Each test has its own folder, which is removed afterwards.
class Preprocess : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / ("permgen_preprocess_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, std::string_view text) const {
        const std::filesystem::path path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }

    std::string run(std::string_view text) {
        sources_ = {};
        diagnostics_.clear();
        result_ = preprocess(write("main.fx", text), options_, sources_, diagnostics_);
        std::string joined;
        for (const Token& token : result_.tokens)
            joined += (joined.empty() || token.text.empty() ? "" : " ") + std::string(token.text);
        return joined;
    }

    std::string code() const { return diagnostics_.empty() ? "" : diagnostics_.front().code; }

    std::filesystem::path folder_;
    SourceOptions options_;
    Sources sources_;
    Preprocessed result_;
    Diagnostics diagnostics_;
};

struct TextCase {
    const char* name;
    std::string text;
    std::string expected;
};

class Expands : public Preprocess, public testing::WithParamInterface<TextCase> {};

TEST_P(Expands, To) {
    EXPECT_EQ(run(GetParam().text), GetParam().expected);
    EXPECT_EQ(code(), "");
}

INSTANTIATE_TEST_SUITE_P(
    Preprocess, Expands,
    testing::Values(
        TextCase{"ObjectMacro", "#define A 1 + 2\nA", "1 + 2"}, TextCase{"NoMacro", "a b", "a b"},
        TextCase{"FunctionMacro", "#define F(x, y) y x\nF(1, 2)", "2 1"},
        TextCase{"CallOverLines", "#define F(x) [x]\nF(\n1\n)", "[ 1 ]"},
        TextCase{"NameWithoutCall", "#define F(x) x\nF + 1", "F + 1"},
        TextCase{"BracketsHideCommas", "#define F(x) [x]\nF((1, 2))", "[ ( 1 , 2 ) ]"},
        TextCase{"ArgumentOfOtherCall", "#define F(x) x x\nF(F(1))", "1 1 1 1"},
        TextCase{"SelfReference", "#define A A + 1\nA", "A + 1"},
        TextCase{"SelfReferenceAsArgument", "#define A A + 1\n#define I(x) x\nI(A)", "A + 1"},
        TextCase{"LeftToRight", "#if 8 - 4 - 2 == 2 && 100 / 10 / 5 == 2\na\n#endif", "a"},
        TextCase{"MutualReference", "#define A B\n#define B A\nA B", "A B"},
        TextCase{"Rescan", "#define A B\n#define B 3\nA", "3"},
        TextCase{"CallFromBody", "#define F(x) x\n#define A F\nA(1)", "1"},
        TextCase{"Stringize", "#define S(x) #x\nS(a  \"b\")", R"("a \"b\"")"},
        TextCase{"Paste", "#define P(a, b) a##b\nP(tex, 2D)", "tex2D"},
        TextCase{"PasteEmpty", "#define P(a, b) a##b\nP(x,) P(,y)", "x y"},
        TextCase{"PasteDoesNotExpandArguments", "#define A 1\n#define P(a) a##_t\nP(A)", "A_t"},
        TextCase{"Variadic", "#define V(a, ...) a(__VA_ARGS__)\nV(f, 1, 2)", "f ( 1 , 2 )"},
        TextCase{"EmptyArguments", "#define F() 1\nF()", "1"},
        TextCase{"SpaceMakesObjectMacro", "#define A (x)\nA", "( x )"},
        TextCase{"Undefine", "#define A 1\n#undef A\nA", "A"},
        TextCase{"ContinuedLine", "#define A 1 \\\n + 2\nA", "1 + 2"},
        TextCase{"If", "#if 1 + 1 == 2\na\n#else\nb\n#endif", "a"},
        TextCase{"Elif", "#if 0\na\n#elif 1\nb\n#else\nc\n#endif", "b"},
        TextCase{"OnlyFirstElif", "#if 0\n#elif 1\nb\n#elif 1\nc\n#endif", "b"},
        TextCase{"Defined", "#define A\n#if defined(A) && !defined B\na\n#endif", "a"},
        TextCase{"Ifndef", "#ifndef A\na\n#endif", "a"},
        TextCase{"NestedSkip", "#if 0\n#if 1\na\n#else\nb\n#endif\n#endif\nc", "c"},
        TextCase{"SkippedTextMayBeAnything", "#if 0\ndon't @ \"\n#endif\nc", "c"},
        TextCase{"UnknownNameIsZero", "#if A\na\n#else\nb\n#endif", "b"},
        TextCase{"DecidedConditionDividesNothing", "#if 0 && 1 / 0\na\n#endif\nb", "b"},
        TextCase{"Precedence", "#if 1 + 2 * 3 == 7 && (1 | 2) == 3 && -1 < 0 && 1 << 3 == 8\na\n#endif", "a"},
        TextCase{"Ternary", "#if 0 ? 0 : 1\na\n#endif", "a"}, TextCase{"WindowsLines", "#define A 1\r\nA\r\n", "1"},
        TextCase{"LineMacro", "\n__LINE__", "2"}, TextCase{"PermgenMacro", "PERMGEN", "1"},
        TextCase{"PragmaIsIgnored", "#pragma warning(disable: 3205)\na", "a"}, TextCase{"EmptyDirective", "#\na", "a"}),
    [](const auto& test) { return test.param.name; });

struct PreprocessError {
    const char* name;
    std::string text;
    const char* code;
    int line;
    int column;
};

class PreprocessRefuses : public Preprocess, public testing::WithParamInterface<PreprocessError> {};

TEST_P(PreprocessRefuses, WithPlace) {
    run(GetParam().text);
    ASSERT_TRUE(has_errors(diagnostics_));
    EXPECT_EQ(diagnostics_[0].code, GetParam().code) << diagnostics_[0].message;
    EXPECT_EQ(diagnostics_[0].place.line, GetParam().line);
    EXPECT_EQ(diagnostics_[0].place.column, GetParam().column);
}

std::string doubling(int levels) {
    std::string text = "#define A0\n";
    for (int i = 1; i <= levels; ++i) {
        const std::string before = "A" + std::to_string(i - 1);
        text += "#define A" + std::to_string(i) + ' ' + before + ' ' + before + '\n';
    }
    return text + 'A' + std::to_string(levels);
}

INSTANTIATE_TEST_SUITE_P(
    Preprocess, PreprocessRefuses,
    testing::Values(PreprocessError{"MissingInclude", "\n#include \"no.fxh\"", "PG002", 2, 2},
                    PreprocessError{"IncludeWithoutName", "#include 3", "PG002", 1, 2},
                    PreprocessError{"IncludeOfFolder", "#include \".\"", "PG002", 1, 2},
                    PreprocessError{"SelfInclude", "#include \"main.fx\"", "PG002", 1, 2},
                    PreprocessError{"IfWithoutEndif", "a\n#if 1\nb", "PG006", 2, 2},
                    PreprocessError{"EndifWithoutIf", "#endif", "PG006", 1, 2},
                    PreprocessError{"ElseTwice", "#if 1\n#else\n#else\n#endif", "PG006", 3, 2},
                    PreprocessError{"NoCondition", "#if\n#endif", "PG006", 1, 2},
                    PreprocessError{"DivisionByZero", "#if 1 / 0\n#endif", "PG006", 1, 2},
                    PreprocessError{"FloatCondition", "#if 1.5\n#endif", "PG006", 1, 5},
                    PreprocessError{"DeepCondition", "#if " + std::string(100000, '(') + "\n#endif", "PG006", 1, 133},
                    PreprocessError{"ErrorDirective", "\n #error stop here", "PG005", 2, 3},
                    PreprocessError{"UnknownDirective", "#inclde <a>", "PG007", 1, 2},
                    PreprocessError{"PackMatrix", "#pragma pack_matrix(row_major)", "PG007", 1, 2},
                    PreprocessError{"DefineNumber", "#define 3 x", "PG008", 1, 2},
                    PreprocessError{"OpenParameters", "#define F(a", "PG008", 1, 9},
                    PreprocessError{"TooManyArguments", "#define F(a) a\nF(1, 2)", "PG010", 2, 1},
                    PreprocessError{"CallWithoutEnd", "#define F(a) a\nF(1", "PG010", 2, 1},
                    PreprocessError{"CallAcrossDirective", "#define F(a) a\nF(1\n#if 1\n)\n#endif", "PG010", 2, 1},
                    PreprocessError{"BadPaste", "#define P(a, b) a##b\nP(+, /)", "PG010", 2, 3},
                    PreprocessError{"DoublingTokens", doubling(40).replace(10, 0, "x"), "PG009", 42, 1},
                    PreprocessError{"DoublingNothing", doubling(40), "PG009", 42, 1},
                    PreprocessError{"StrayByte", "a\n @", "PG004", 2, 2},
                    PreprocessError{"NulByte", std::string("a\0b", 3), "PG004", 1, 2},
                    PreprocessError{"OpenString", "\"abc", "PG004", 1, 1},
                    PreprocessError{"OpenComment", "a /*", "PG003", 1, 3}),
    [](const auto& test) { return test.param.name; });

TEST_F(Preprocess, LooksBesideTheIncluderAndThenInTheFolders) {
    write("near/a.fxh", "near");
    write("far/a.fxh", "far");
    write("far/b.fxh", "#include \"c.fxh\"");
    write("far/c.fxh", "beside");
    options_.include_folders = {(folder_ / "far").string()};
    EXPECT_EQ(run("#include \"near/a.fxh\"\n#include <a.fxh>\n#include \"b.fxh\""), "near far beside");
}

TEST_F(Preprocess, DependenciesAreEveryFileOnceTheEffectFirst) {
    const std::string a = write("a.fxh", "#pragma once\na");
    EXPECT_EQ(run("#include \"a.fxh\"\n#include \"sub/../a.fxh\""), "a");
    EXPECT_EQ(result_.dependencies, (std::vector<std::string>{(folder_ / "main.fx").string(), a}));
}

TEST_F(Preprocess, BackslashesInIncludesAreSlashes) {
    write("sub/a.fxh", "a");
    EXPECT_EQ(run("#include \"sub\\a.fxh\""), "a");
}

TEST_F(Preprocess, IncludesThatDoubleAtEveryLevelEnd) {
    for (int i = 0; i < 40; ++i) {
        const std::string next = "#include \"f" + std::to_string(i + 1) + ".fxh\"\n";
        write("f" + std::to_string(i) + ".fxh", next + next);
    }
    write("f40.fxh", "");
    run("#include \"f0.fxh\"");
    EXPECT_EQ(code(), "PG009");
}

TEST_F(Preprocess, MacroTokensHaveThePlaceOfUse) {
    run("#define A x + y\n\n  A");
    ASSERT_GE(result_.tokens.size(), 3u);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(result_.tokens[i].at.line, 3);
        EXPECT_EQ(result_.tokens[i].at.column, 3);
    }
}

TEST_F(Preprocess, ArgumentsKeepTheirOwnPlace) {
    run("#define F(a) a\nF(\n   x)");
    EXPECT_EQ(result_.tokens[0].at.line, 3);
    EXPECT_EQ(result_.tokens[0].at.column, 4);
}

TEST_F(Preprocess, LineDirectiveMovesPlaces) {
    run("#line 100 \"author.fx\"\n@");
    ASSERT_FALSE(diagnostics_.empty());
    EXPECT_EQ(format(diagnostics_[0]).substr(0, 16), "author.fx:100:1:");
}

TEST_F(Preprocess, OptionsDefineMacros) {
    options_.defines = {{"A", "2 + 1"}, {"B", ""}};
    EXPECT_EQ(run("A\n#ifdef B\nb\n#endif"), "2 + 1 b");
}

TEST_F(Preprocess, EffectThatDoesNotExist) {
    preprocess((folder_ / "none.fx").string(), options_, sources_, diagnostics_);
    EXPECT_EQ(code(), "PG001");
}

TEST_F(Preprocess, EffectThatIsAFolder) {
    preprocess(folder_.string(), options_, sources_, diagnostics_);
    EXPECT_EQ(code(), "PG001");
}

}  // namespace
}  // namespace permgen

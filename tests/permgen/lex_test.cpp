#include "front/lex.h"

#include <gtest/gtest.h>

namespace permgen {
namespace {

struct Lexed {
    Sources sources;
    Tokens tokens;
    Diagnostics diagnostics;
};

void lex_text(Lexed& lexed, std::string_view text) {
    lexed.sources.files.push_back(make_source("t.fx", text));
    lexed.tokens = lex(lexed.sources.files.back(), lexed.sources.name_index("t.fx"), lexed.sources, lexed.diagnostics);
}

struct SplitCase {
    const char* name;
    std::string text;
    std::string tokens;  // each followed by '|'
};

class Split : public testing::TestWithParam<SplitCase> {};

TEST_P(Split, Tokens) {
    Lexed lexed;
    lex_text(lexed, GetParam().text);
    std::string joined;
    for (const Token& token : lexed.tokens) joined += std::string(token.text) + '|';
    EXPECT_EQ(joined, GetParam().tokens);
    EXPECT_TRUE(lexed.diagnostics.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Lex, Split,
    testing::Values(SplitCase{"Nothing", "", ""}, SplitCase{"ByteOrderMark", "\xEF\xBB\xBFint", "int|"},
                    SplitCase{"LineComment", "a // b\nc", "a|c|"}, SplitCase{"BlockComment", "a/* b\n */c", "a|c|"},
                    SplitCase{"JoinedLine", "ab\\\ncd", "abcd|"}, SplitCase{"JoinedWindowsLine", "ab\\\r\ncd", "abcd|"},
                    SplitCase{"FloatSuffix", "1.0f+.5h", "1.0f|+|.5h|"}, SplitCase{"Exponent", "1e-3-2", "1e-3|-|2|"},
                    SplitCase{"HexMinus", "0xE-1", "0xE|-|1|"},
                    SplitCase{"LongestOperator", "a<<=b>=c", "a|<<=|b|>=|c|"},
                    SplitCase{"EscapedQuote", R"("a\"b" c)", R"("a\"b"|c|)"},
                    SplitCase{"CommentInString", R"("//")", R"("//"|)"},
                    SplitCase{"DivisionIsNoComment", "a/b", "a|/|b|"}),
    [](const auto& test) { return test.param.name; });

struct PlaceCase {
    const char* name;
    std::string text;
    int line;
    int column;
};

class LastToken : public testing::TestWithParam<PlaceCase> {};

TEST_P(LastToken, StandsWhereTheAuthorWroteIt) {
    Lexed lexed;
    lex_text(lexed, GetParam().text);
    ASSERT_FALSE(lexed.tokens.empty());
    EXPECT_EQ(lexed.tokens.back().at.line, GetParam().line);
    EXPECT_EQ(lexed.tokens.back().at.column, GetParam().column);
}

INSTANTIATE_TEST_SUITE_P(Lex, LastToken,
                         testing::Values(PlaceCase{"First", "x", 1, 1}, PlaceCase{"BehindMark", "\xEF\xBB\xBFx", 1, 1},
                                         PlaceCase{"Unix", "a\n  x", 2, 3}, PlaceCase{"Windows", "a\r\n  x", 2, 3},
                                         PlaceCase{"OldMac", "a\r  x", 2, 3},
                                         PlaceCase{"BehindJoinedLine", "a \\\n  x", 2, 3},
                                         PlaceCase{"BehindComment", "/* \n */ x", 2, 5},
                                         PlaceCase{"BehindJoinedComment", "// a \\\n b\nx", 3, 1}),
                         [](const auto& test) { return test.param.name; });

TEST(Lex, CommentWithoutEndIsReportedAtItsBeginning) {
    Lexed lexed;
    lex_text(lexed, "a\n  /* b");
    ASSERT_EQ(lexed.diagnostics.size(), 1u);
    EXPECT_EQ(lexed.diagnostics[0].code, "PG003");
    EXPECT_EQ(lexed.diagnostics[0].place.line, 2);
    EXPECT_EQ(lexed.diagnostics[0].place.column, 3);
}

TEST(Lex, EveryByteIsSomeToken) {
    std::string text;
    for (int byte = 0; byte < 256; ++byte) text += std::string(1, static_cast<char>(byte)) + '\n';
    Lexed lexed;
    lex_text(lexed, text);
    EXPECT_GT(lexed.tokens.size(), 200u);
}

}  // namespace
}  // namespace permgen

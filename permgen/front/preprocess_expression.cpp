#include "front/preprocess_expression.h"

#include <array>
#include <limits>

namespace permgen {
namespace {

// Parentheses, unary operators and ?: nest by recursion; hand-written conditions stay below this depth.
constexpr int max_depth = 256;

struct Binary {
    std::string_view spelling;
    int precedence;
};
constexpr std::array<Binary, 18> binaries = {{{"||", 1},
                                              {"&&", 2},
                                              {"|", 3},
                                              {"^", 4},
                                              {"&", 5},
                                              {"==", 6},
                                              {"!=", 6},
                                              {"<", 7},
                                              {">", 7},
                                              {"<=", 7},
                                              {">=", 7},
                                              {"<<", 8},
                                              {">>", 8},
                                              {"+", 9},
                                              {"-", 9},
                                              {"*", 10},
                                              {"/", 10},
                                              {"%", 10}}};

class Evaluator {
public:
    Evaluator(std::span<const Token> tokens, const IntegerNames& names) : tokens_(tokens), names_(names) {}

    IntegerResult run() {
        const std::int64_t value = conditional(true);
        if (!failed_ && next_ < tokens_.size()) fail("unexpected '" + std::string(tokens_[next_].text) + "'");
        if (failed_) return {std::nullopt, problem_, at_};
        return {value, {}, {}};
    }

private:
    bool at(std::string_view spelling) const { return next_ < tokens_.size() && tokens_[next_].is(spelling); }

    std::int64_t fail(std::string problem) {
        if (!failed_) {
            problem_ = std::move(problem);
            if (next_ < tokens_.size()) at_ = tokens_[next_].at;
        }
        failed_ = true;
        return 0;
    }

    std::int64_t conditional(bool needed) {
        if (++depth_ > max_depth) return fail("the expression is nested too deeply");
        std::int64_t value = binary(1, needed);
        if (!failed_ && at("?")) {
            ++next_;
            const bool chosen = value != 0;
            const std::int64_t then = conditional(needed && chosen);
            if (!failed_ && !at(":")) fail("expected ':'");
            ++next_;
            const std::int64_t otherwise = failed_ ? 0 : conditional(needed && !chosen);
            value = chosen ? then : otherwise;
        }
        --depth_;
        return value;
    }

    int precedence_here() const {
        if (next_ >= tokens_.size()) return 0;
        for (const Binary& binary : binaries)
            if (tokens_[next_].is(binary.spelling)) return binary.precedence;
        return 0;
    }

    std::int64_t binary(int lowest, bool needed) {
        std::int64_t left = unary(needed);
        while (!failed_) {
            const int precedence = precedence_here();
            if (precedence < lowest) break;
            const Token& operation = tokens_[next_++];
            // The right side of a decided && or || is parsed but not evaluated: "defined(N) && 8 / N".
            const bool decided = (operation.is("&&") && left == 0) || (operation.is("||") && left != 0);
            const std::int64_t right = binary(precedence + 1, needed && !decided);
            if (!failed_) left = apply(operation, left, right, needed);
        }
        return left;
    }

    std::int64_t unary(bool needed) {
        if (++depth_ > max_depth) return fail("the expression is nested too deeply");
        const std::int64_t value = primary(needed);
        --depth_;
        return value;
    }

    std::int64_t primary(bool needed) {
        if (next_ >= tokens_.size()) return fail("the expression ends too early");
        const Token& token = tokens_[next_];
        if (token.is("(")) {
            ++next_;
            const std::int64_t value = conditional(needed);
            if (failed_) return 0;
            if (!at(")")) return fail("expected ')'");
            ++next_;
            return value;
        }
        if (token.is("-") || token.is("+") || token.is("!") || token.is("~")) {
            ++next_;
            const std::int64_t value = unary(needed);
            if (token.is("-")) return static_cast<std::int64_t>(0 - static_cast<std::uint64_t>(value));
            if (token.is("!")) return value == 0 ? 1 : 0;
            if (token.is("~")) return ~value;
            return value;
        }
        if (token.kind == TokenKind::Number) {
            const std::optional<std::int64_t> value = integer_literal(token.text);
            if (!value) return fail("'" + std::string(token.text) + "' is not an integer");
            ++next_;
            return *value;
        }
        if (token.is_identifier()) {
            const std::optional<std::int64_t> value = names_(token.text);
            if (!value) return fail("'" + std::string(token.text) + "' is not a constant integer");
            ++next_;
            return *value;
        }
        return fail("unexpected '" + std::string(token.text) + "'");
    }

    std::int64_t apply(const Token& operation, std::int64_t left, std::int64_t right, bool needed) {
        const auto a = static_cast<std::uint64_t>(left);
        const auto b = static_cast<std::uint64_t>(right);
        const std::string_view o = operation.text;
        if (o == "||") return left != 0 || right != 0;
        if (o == "&&") return left != 0 && right != 0;
        if (o == "|") return left | right;
        if (o == "^") return left ^ right;
        if (o == "&") return left & right;
        if (o == "==") return left == right;
        if (o == "!=") return left != right;
        if (o == "<") return left < right;
        if (o == ">") return left > right;
        if (o == "<=") return left <= right;
        if (o == ">=") return left >= right;
        if (o == "<<") return static_cast<std::int64_t>(a << (b & 63));
        if (o == ">>") return left >> (b & 63);
        if (o == "+") return static_cast<std::int64_t>(a + b);
        if (o == "-") return static_cast<std::int64_t>(a - b);
        if (o == "*") return static_cast<std::int64_t>(a * b);
        if (right == 0) return needed ? fail("division by zero") : 0;
        if (left == std::numeric_limits<std::int64_t>::min() && right == -1) return o == "/" ? left : 0;
        return o == "/" ? left / right : left % right;
    }

    std::span<const Token> tokens_;
    const IntegerNames& names_;
    std::size_t next_ = 0;
    int depth_ = 0;
    bool failed_ = false;
    std::string problem_;
    Location at_;
};

}  // namespace

IntegerResult evaluate_integer(std::span<const Token> tokens, const IntegerNames& names) {
    return Evaluator(tokens, names).run();
}

std::optional<std::int64_t> integer_literal(std::string_view text) {
    unsigned base = 10;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        base = 16;
        text.remove_prefix(2);
    } else if (text.size() > 1 && text[0] == '0') {
        base = 8;
    }
    std::uint64_t value = 0;
    std::size_t digits = 0;
    for (; digits < text.size(); ++digits) {
        const char c = text[digits];
        unsigned digit = 99;
        if (c >= '0' && c <= '9') digit = static_cast<unsigned>(c - '0');
        if (c >= 'a' && c <= 'f') digit = static_cast<unsigned>(c - 'a') + 10;
        if (c >= 'A' && c <= 'F') digit = static_cast<unsigned>(c - 'A') + 10;
        if (digit >= base) break;
        if (value > (std::numeric_limits<std::uint64_t>::max() - digit) / base) return std::nullopt;
        value = value * base + digit;
    }
    if (digits == 0 || text.size() - digits > 3) return std::nullopt;
    for (const char c : text.substr(digits))
        if (c != 'u' && c != 'U' && c != 'l' && c != 'L') return std::nullopt;
    return static_cast<std::int64_t>(value);
}

}  // namespace permgen

#include "back/compile_log.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

namespace permgen {
namespace {

struct Complaint {
    Severity severity = Severity::Error;
    int line = 0;  ///< of the lowered text, from 1
    std::string token;
    std::string text;
};

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

bool take_prefix(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
}

std::optional<int> take_number(std::string_view& text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

/// "ERROR: 0:12: 'token' : text": string 0 is the only input.
std::optional<Complaint> parse_complaint(std::string_view line) {
    Complaint complaint;
    // The SPIR-V builder leaves out what it cannot translate, and still makes a module.
    if (take_prefix(line, "Missing functionality: ") || take_prefix(line, "TBD functionality: ")) {
        complaint.text = "the shader compiler cannot translate part of this entry point (" + std::string(trim(line)) +
                         "); write it another way";
        return complaint;
    }
    if (take_prefix(line, "WARNING: "))
        complaint.severity = Severity::Warning;
    else if (!take_prefix(line, "ERROR: "))
        return std::nullopt;
    if (take_prefix(line, "0:")) {
        const auto number = take_number(line);
        if (!number || !take_prefix(line, ":")) return std::nullopt;
        complaint.line = *number;
    }
    line = trim(line);
    if (line.ends_with("No code generated.")) return std::nullopt;  // a summary of the other messages
    if (line.starts_with('\'')) {
        const std::size_t end = line.find("' :");
        if (end != std::string_view::npos) {
            complaint.token = line.substr(1, end - 1);
            line = trim(line.substr(end + 3));
        }
    }
    complaint.text = line;
    return complaint;
}

/// "(12): error at column 5, HLSL parsing failed.": the last column of the token it stopped at.
struct Stop {
    int line;
    int column;
};
std::optional<Stop> parse_stop(std::string_view line) {
    const std::size_t open = line.find('(');
    if (!line.ends_with("HLSL parsing failed.") || open == std::string_view::npos) return std::nullopt;
    line.remove_prefix(open + 1);
    const auto number = take_number(line);
    if (!number || !take_prefix(line, "): error at column ")) return std::nullopt;
    const auto column = take_number(line);
    return column ? std::optional(Stop{*number, *column}) : std::nullopt;
}

std::string nth_line(std::istream& text, int number) {
    std::string line;
    for (int i = 0; i < number; ++i)
        if (!std::getline(text, line)) return {};
    return line;
}

std::vector<std::size_t> occurrences(const std::string& line, const std::string& token) {
    std::vector<std::size_t> found;
    if (token.empty()) return found;
    for (std::size_t at = line.find(token); at != std::string::npos; at = line.find(token, at + 1)) {
        const std::size_t end = at + token.size();
        const bool joined_left = is_word(token.front()) && at > 0 && is_word(line[at - 1]);
        const bool joined_right = is_word(token.back()) && end < line.size() && is_word(line[end]);
        if (!joined_left && !joined_right) found.push_back(at);
    }
    return found;
}

/// The token whose last column is `column` (from 1) in the lowered line.
std::string token_ending_at(const std::string& line, int column) {
    const std::size_t end = static_cast<std::size_t>(column);
    if (column <= 0 || end > line.size()) return {};
    std::size_t begin = end - 1;
    if (is_word(line[begin]))
        while (begin > 0 && is_word(line[begin - 1])) --begin;
    return line.substr(begin, end - begin);
}

/// The column of the lowered line's token in the author's line; 0 if unknown.
int author_column(const std::string& author, const std::string& lowered, const std::string& token, int lowered_end) {
    const auto there = occurrences(author, token);
    const auto here = occurrences(lowered, token);
    if (there.empty()) return 0;
    std::size_t which = 0;
    if (lowered_end > 0 && there.size() == here.size()) {
        const std::size_t begin = static_cast<std::size_t>(lowered_end) - token.size();
        which = static_cast<std::size_t>(std::find(here.begin(), here.end(), begin) - here.begin());
    }
    return static_cast<int>(there[which < there.size() ? which : 0]) + 1;
}

bool is_syntax_error(const Complaint& complaint) {
    return complaint.text == "Expected";
}

SourceLocation author_place(const LoweredModule& module, const Complaint& complaint, const std::optional<Stop>& stop) {
    const std::size_t index = static_cast<std::size_t>(complaint.line) - 1;
    if (complaint.line <= 0 || index >= module.line_map.size() || module.line_map[index].file.empty())
        return module.place;
    SourceLocation place = module.line_map[index];
    std::ifstream file(place.file);
    const std::string author = nth_line(file, place.line);
    std::istringstream text(module.hlsl);
    const std::string lowered = nth_line(text, complaint.line);
    // The parser stops after the position where the expected token is missing.
    int column = is_syntax_error(complaint) ? 0 : author_column(author, lowered, complaint.token, 0);
    if (column == 0 && stop && stop->line == complaint.line)
        column = author_column(author, lowered, token_ending_at(lowered, stop->column), stop->column);
    if (column > 0) place.column = column;
    return place;
}

std::string sentence(const Complaint& complaint, const LoweredModule& module, const std::optional<Stop>& stop) {
    if (is_syntax_error(complaint)) {
        const bool word = !complaint.token.empty() && is_word(complaint.token.front());
        const std::string expected = "expected " + (word ? complaint.token : "'" + complaint.token + "'");
        if (!stop || stop->line != complaint.line) return "syntax error: " + expected + " here or on the line before";
        std::istringstream text(module.hlsl);
        return "syntax error at '" + token_ending_at(nth_line(text, stop->line), stop->column) + "': " + expected;
    }
    return complaint.token.empty() ? complaint.text : "'" + complaint.token + "': " + complaint.text;
}

}  // namespace

Diagnostics read_compile_log(const std::string& log, const LoweredModule& module) {
    std::vector<Complaint> complaints;
    std::optional<Stop> stop;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        const std::string_view trimmed = trim(line);
        if (const auto found = parse_stop(trimmed))
            stop = found;
        else if (auto complaint = parse_complaint(trimmed))
            complaints.push_back(std::move(*complaint));
    }

    // A function that fails to compile makes the generated wrapper, which calls it, fail as well. That error is dropped
    // if the author's own lines have one.
    const auto is_authors = [&](const Complaint& complaint) {
        const std::size_t index = static_cast<std::size_t>(complaint.line) - 1;
        return complaint.line > 0 && index < module.line_map.size() && !module.line_map[index].file.empty();
    };
    const auto is_authors_error = [&](const Complaint& complaint) {
        return is_authors(complaint) && complaint.severity == Severity::Error;
    };
    if (std::any_of(complaints.begin(), complaints.end(), is_authors_error))
        std::erase_if(complaints, [&](const Complaint& complaint) { return !is_authors(complaint); });

    Diagnostics diagnostics;
    std::vector<std::pair<int, Severity>> said;
    for (const Complaint& complaint : complaints) {
        const std::pair key(complaint.line, complaint.severity);
        if (complaint.line > 0 && std::find(said.begin(), said.end(), key) != said.end()) continue;
        said.push_back(key);
        const bool error = complaint.severity == Severity::Error;
        diagnostics.push_back({complaint.severity, error ? "PG050" : "PG051", author_place(module, complaint, stop),
                               sentence(complaint, module, stop)});
    }
    return diagnostics;
}

}  // namespace permgen

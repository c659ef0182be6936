#include "report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <vector>

#include "base64.h"

namespace tyndall::rig {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view style = R"css(
:root{color-scheme:light dark;--ink:#1c2126;--dim:#5d6873;--paper:#f6f5f1;--card:#fff;--line:#dcd9d0;--bad:#b3261e;
--chip:#efece3;--code:#f0eee7}
@media(prefers-color-scheme:dark){:root{--ink:#e6e4dd;--dim:#9aa3ab;--paper:#15181b;--card:#1e2226;--line:#343a40;
--bad:#ff8a7a;--chip:#2b3136;--code:#14171a}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 system-ui,sans-serif}
main{max-width:1180px;margin:0 auto;padding:32px 20px 64px}
h1{font-size:26px;margin:0 0 4px}
.lead{color:var(--dim);margin:0 0 20px}
nav{margin:0 0 28px;padding:12px 16px;background:var(--card);border:1px solid var(--line);border-radius:8px}
nav h2{font-size:13px;margin:0 0 6px;color:var(--dim);font-weight:600}
nav a{display:inline-block;margin:2px 16px 2px 0;color:inherit}
article{background:var(--card);border:1px solid var(--line);border-left:5px solid var(--bad);border-radius:8px;
padding:18px 20px;margin:0 0 22px}
article h2{font-size:18px;margin:0;overflow-wrap:anywhere}
.where{color:var(--dim);margin:2px 0 10px}
.reason{white-space:pre-line;margin:0 0 14px;color:var(--bad);overflow-wrap:anywhere}
.pictures{display:grid;grid-template-columns:repeat(3,minmax(0,1fr));gap:14px;margin:0 0 14px}
figure{margin:0}
figure img{width:100%;display:block;image-rendering:pixelated;background:#000;border:1px solid var(--line);border-radius:4px}
figcaption{font-size:13px;color:var(--dim);margin-top:4px}
.none{display:flex;align-items:center;justify-content:center;min-height:120px;height:calc(100% - 24px);
border:1px dashed var(--line);border-radius:4px;color:var(--dim);font-size:13px;padding:8px;text-align:center}
.chips{margin:0 0 12px}
.chips code{display:inline-block;background:var(--chip);border-radius:12px;padding:1px 10px;margin:2px 6px 2px 0}
dl{display:grid;grid-template-columns:max-content 1fr;gap:2px 18px;margin:0 0 12px;font-variant-numeric:tabular-nums}
dt{color:var(--dim)}dd{margin:0}
pre{margin:0;background:var(--code);border:1px solid var(--line);border-radius:6px;padding:10px 12px;white-space:pre-wrap;
overflow-wrap:anywhere;user-select:all;font:13px/1.45 ui-monospace,monospace}
code{font:13px ui-monospace,monospace}
@media(max-width:640px){.pictures{grid-template-columns:1fr}}
)css";

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    return out;
}

std::string bytesOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string text(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

struct Entry {
    std::string key;
    fs::path folder;
    Json json;

    auto order() const {
        return std::tuple(text(json, "effect"), text(json, "technique"), text(json, "check"), text(json, "pass"), key);
    }
};

std::vector<Entry> readEntries(const std::string& folder) {
    std::vector<Entry> entries;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        Json json = Json::parse(bytesOf(at->path() / "entry.json"), nullptr, false);
        if (!json.is_object())
            json = {{"technique", at->path().filename().string()},
                    {"reason", "this entry's entry.json cannot be read"}};
        entries.push_back({at->path().filename().string(), at->path(), std::move(json)});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.order() < b.order(); });
    return entries;
}

std::string figure(const Entry& entry, const std::string& name, const std::string& caption, std::string_view absent) {
    const std::string png = bytesOf(entry.folder / (name + ".png"));
    const std::string picture =
        png.empty() ? fmt::format("<div class=\"none\">{}</div>", absent)
                    : fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", escaped(caption), base64(png));
    return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", picture, escaped(caption));
}

std::string number(const Json& value) {
    return value.is_number() ? fmt::format("{:.6g}", value.get<double>())
                             : std::string("undefined: nothing is expected");
}

std::string place(const Json& json) {
    const Json& pixel = json.at("pixel");
    return fmt::format("pixel ({}, {}), channel {}", pixel.at(0).get<int>(), pixel.at(1).get<int>(),
                       json.at("channel").get<int>());
}

std::string figuresTable(const Json& figures) {
    std::string rows;
    const auto row = [&](std::string_view name, const std::string& value) {
        rows += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, escaped(value));
    };
    if (figures.contains("largest_difference"))
        row("largest difference",
            number(figures.at("largest_difference")) + " at " + place(figures.at("largest_difference_at")));
    if (figures.contains("relative_l2")) row("relative L2", number(figures.at("relative_l2")));
    if (figures.contains("differing_values")) row("values that differ", figures.at("differing_values").dump());
    if (figures.contains("nan")) {
        std::string bad = figures.at("nan").dump() + " NaN, " + figures.at("infinite").dump() + " infinite";
        if (figures.contains("first_not_finite")) bad += ", the first at " + place(figures.at("first_not_finite"));
        row("not finite", bad);
    }
    return rows.empty() ? rows : "<dl>" + rows + "</dl>\n";
}

std::string article(const Entry& entry) {
    const Json& json = entry.json;
    std::string where = text(json, "effect") + ".fx";
    if (!text(json, "pass").empty()) where += ", pass " + text(json, "pass");
    if (!text(json, "check").empty()) where += ": " + text(json, "check");
    std::string html = fmt::format(
        "<article id=\"{}\">\n<h2>{}</h2>\n<p class=\"where\">{}</p>\n<p class=\"reason\">{}</p>\n", escaped(entry.key),
        escaped(text(json, "technique")), escaped(where), escaped(text(json, "reason")));
    if (json.contains("constants") && !json.at("constants").empty()) {
        html += "<p class=\"chips\">";
        for (const auto& [name, value] : json.at("constants").items())
            html += fmt::format("<code>{} = {}</code>", escaped(name),
                                escaped(value.is_string() ? value.get<std::string>() : value.dump()));
        html += "</p>\n";
    }
    if (json.contains("pictures") && !json.at("pictures").empty()) {
        const std::string white = json.contains("white") ? fmt::format("white is {}", number(json.at("white"))) : "";
        html += "<div class=\"pictures\">\n" + figure(entry, "image", "drawn; " + white, "nothing was drawn") +
                figure(entry, "expected", "expected; " + white, "no image to compare with") +
                figure(entry, "difference", "difference, black for 0", "no difference to show") + "</div>\n";
    }
    if (json.contains("figures")) html += figuresTable(json.at("figures"));
    if (!text(json, "command").empty()) html += "<pre>" + escaped(text(json, "command")) + "</pre>\n";
    return html + "</article>\n";
}

std::string shortName(const Json& json) {
    const std::string pass = text(json, "pass");
    return text(json, "technique") + (pass.empty() ? "" : ", " + pass) + ": " + text(json, "check");
}

/// An entry from another version, or edited by hand, must not break the page.
std::string safeArticle(const Entry& entry) {
    try {
        return article(entry);
    } catch (const Json::exception&) {
        return fmt::format(
            "<article><h2>{}</h2>\n<p class=\"reason\">its entry.json has another form than this page's; "
            "remove the folder and run the test again</p></article>\n",
            escaped(entry.key));
    }
}

}  // namespace

std::string reportPage(const std::string& entriesFolder) {
    const std::vector<Entry> entries = readEntries(entriesFolder);
    std::set<std::pair<std::string, std::string>> techniques;
    for (const Entry& entry : entries) techniques.insert({text(entry.json, "effect"), text(entry.json, "technique")});

    std::string html = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
        "<title>{0}{1}\n<style>{2}</style></head>\n<body><main>\n<h1>{3}</h1>\n",
        entries.size(), pageMark, style,
        entries.empty()
            ? "Nothing fails"
            : fmt::format("{} comparison{} in {} technique{} fail{}", entries.size(), entries.size() == 1 ? "" : "s",
                          techniques.size(), techniques.size() == 1 ? "" : "s", entries.size() == 1 ? "s" : ""));
    html += entries.empty()
                ? "<p class=\"lead\">Every comparison that failed before has passed since.</p>\n"
                : "<p class=\"lead\">The drawn picture, the expected picture and their difference. Magenta marks "
                  "NaN and infinity. The command below each one repeats it; the float images are in "
                  "<code>entries</code>.</p>\n";
    if (entries.size() > 1) {
        html += "<nav><h2>Failing</h2>\n";
        for (const Entry& entry : entries)
            html += fmt::format("<a href=\"#{}\">{}</a>\n", escaped(entry.key), escaped(shortName(entry.json)));
        html += "</nav>\n";
    }
    for (const Entry& entry : entries) html += safeArticle(entry);
    return html + "</main></body></html>\n";
}

std::vector<fs::path> entriesOfOtherTechniques(const std::string& entriesFolder, const std::string& effect,
                                               const std::vector<std::string>& techniques) {
    std::vector<fs::path> others;
    for (const Entry& entry : readEntries(entriesFolder))
        if (text(entry.json, "effect") == effect &&
            std::find(techniques.begin(), techniques.end(), text(entry.json, "technique")) == techniques.end())
            others.push_back(entry.folder);
    return others;
}

}  // namespace tyndall::rig

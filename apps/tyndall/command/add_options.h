// Declares options to the command line's parser: helpers, and the groups that commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>

#include "options.h"
#include "words.h"

namespace tyndall::app {

/// An option that takes one of a list of words.
template <class T, std::size_t N>
CLI::Option* addChoice(CLI::App& app, const char* name, T& value, const Words<T, N>& words, const std::string& help) {
    std::map<std::string, T> meanings;
    std::string list;
    for (const auto& [word, meaning] : words) {
        meanings.emplace(word, meaning);
        list += (list.empty() ? "" : ", ") + std::string(word);
    }
    return app
        .add_option_function<std::string>(
            name,
            [&value, meanings, list, name](const std::string& text) {
                const auto found = meanings.find(text);
                if (found == meanings.end())
                    throw CLI::ValidationError(fmt::format("{}: \"{}\" is not one of {}", name, text, list));
                value = found->second;
            },
            fmt::format("{}: {}", help, list))
        ->type_name("NAME");
}

template <class T>
CLI::Option* addOptional(CLI::App& app, const char* name, std::optional<T>& value, const char* type, const char* help) {
    return app
        .add_option_function<T>(
            name, [&value](const T& given) { value = given; }, help)
        ->type_name(type);
}

/// Scene, camera, size and time. `size` is as written; checkView() reads it.
void addViewOptions(CLI::App& app, ViewOptions& view, std::string& size);
Result<void> checkView(ViewOptions& view, const std::string& size);

/// --technique, as its set of terms.
void addTechnique(CLI::App& app, std::optional<TermSet>& terms, const std::string& help);

void addShadowSize(CLI::App& app, std::uint32_t& size);
Result<void> checkShadowSize(std::uint32_t size);

// Each command's own options as written, and checks of their combinations.
void addRender(CLI::App& app, RenderOptions& options, std::string& size);
Result<void> checkRender(RenderOptions& options, bool outputGiven);
void addExplain(CLI::App& app, ExplainOptions& options, std::string& size);
Result<void> checkShafts(ShaftOptions& shafts, const SliceCount& slices);
void addReference(CLI::App& app, ReferenceOptions& options, std::string& size);
Result<void> checkReference(const ReferenceOptions& options, bool shadowSizeGiven);
void addCompare(CLI::App& app, CompareOptions& options);
Result<void> checkCompare(const CompareOptions& options);

}  // namespace tyndall::app

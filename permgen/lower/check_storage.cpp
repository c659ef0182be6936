#include "lower/check_storage.h"

#include <algorithm>

#include "common/nearest.h"
#include "d3d9/image_formats.h"
#include "d3d9/storage_types.h"
#include "front/parse_cursor.h"
#include "front/report.h"
#include "lower/lower_types.h"

namespace permgen {
namespace {

constexpr int max_element_depth = 16;

bool is_image(const StorageResource& storage) {
    return d3d9::find_storage_type(storage.type)->kind == ResourceKind::StorageImage;
}

/// The format of 32 bits a component that the element gives: float2 is rg32f. None for a type without a format.
ImageFormat element_format(const NumericType& type) {
    if (type.is_matrix || type.scalar == ScalarType::Bool) return ImageFormat::None;
    constexpr std::string_view letters[] = {"r", "rg", "", "rgba"};
    const std::string_view suffix = type.scalar == ScalarType::Float ? "f"
                                    : type.scalar == ScalarType::Int ? "i"
                                                                     : "ui";
    const d3d9::ImageFormatRow* row =
        d3d9::find_image_format(std::string(letters[type.columns - 1]) + "32" + std::string(suffix));
    return row ? row->format : ImageFormat::None;
}

class StorageChecker {
public:
    StorageChecker(const ParsedEffect& effect, const Sources& sources, Diagnostics& diagnostics)
        : effect_(effect), sources_(sources), diagnostics_(diagnostics) {}

    void declaration(const StorageResource& storage) const {
        if (storage.format) return attribute(storage);
        if (!d3d9::find_storage_type(storage.type)->has_element) return;
        if (!is_image(storage)) return element(storage, storage.element, 0);
        if (texel_format(effect_, storage) == ImageFormat::None)
            error("PG041", storage.element.at,
                  "a " + std::string(storage.type) + " cannot hold '" + text_of(effect_, storage.element.range) +
                      "'; write float, int or uint with 1, 2 or 4 components");
    }

    void body(const Function& function) const {
        for (std::size_t i = function.body.begin; i < function.body.end; ++i) {
            const Token& word = effect_.tokens[i];
            if (word.is_identifier() && d3d9::find_storage_type(word.text))
                error("PG041", word.at,
                      quoted(word) + " may only be declared at file scope; use the resource by its name");
        }
    }

    void call(const Call& call) const {
        const Token& name = effect_.tokens[call.name_token];
        if (effect_.tokens[call.name_token - 1].is(".")) return method(call, name);
        if (name.is("InterlockedCompareStore"))
            return error("PG047", name.at,
                         "'InterlockedCompareStore' is not supported; write InterlockedCompareExchange");
        if (name.text.starts_with("Interlocked")) return interlocked(call, name);
        for (const Function& callee : effect_.functions)
            if (callee.name == name.text && callee.parameters.size() == call.arguments.size())
                for (std::size_t p = 0; p < callee.parameters.size(); ++p)
                    argument(call, callee, callee.parameters[p], call.arguments[p]);
    }

private:
    // [[vk::image_format("...")]] must fit the element, since the shader converts components, and no more.
    void attribute(const StorageResource& storage) const {
        const std::string type(storage.type);
        if (!is_image(storage))
            return error("PG041", storage.format->at,
                         "a " + type + " has no image format; remove [[vk::image_format(...)]]");
        const d3d9::ImageFormatRow* format = d3d9::find_image_format(storage.format->name);
        if (!format) {
            std::vector<std::string_view> names;
            for (const d3d9::ImageFormatRow& row : d3d9::image_formats) names.push_back(row.name);
            const std::string meant = suggestion(storage.format->name, names, "; did you mean '", "'?");
            return error("PG041", storage.format->at,
                         "'" + std::string(storage.format->name) + "' is not an image format" +
                             (meant.empty() ? "; write one such as rgba16f, r32f or rgba8" : meant));
        }
        const auto element = numeric_type(effect_, storage.element);
        if (!element || element->is_matrix || element->scalar != format->scalar ||
            element->columns != format->components)
            error("PG041", storage.element.at,
                  "a " + type + " of " + std::string(format->name) + " cannot hold '" +
                      text_of(effect_, storage.element.range) + "'; write " + type + "<" +
                      spelling(format->scalar, format->components) + ">");
    }

    void error(const char* code, Location at, std::string message) const {
        report_error(diagnostics_, code, sources_.place(at), std::move(message));
    }

    // A number or a struct of numbers.
    void element(const StorageResource& storage, const TypeName& type, int depth) const {
        if (const auto number = numeric_type(effect_, type)) {
            if (number->scalar == ScalarType::Bool)
                error(
                    "PG041", type.at,
                    "'" + std::string(storage.name) + "' cannot hold a bool, which has no size in memory; write uint");
            return;
        }
        const Struct* structure = find_struct(effect_, type);
        if (!structure || depth >= max_element_depth)
            return error("PG041", type.at,
                         "a " + std::string(storage.type) + " cannot hold '" + std::string(type.name) +
                             "'; write a number's type, such as float4, or a struct of such");
        for (const Variable& member : structure->members) element(storage, member.type, depth + 1);
    }

    /// The storage resource that the argument begins with.
    const StorageResource* resource_at(const Call& call, std::size_t token) const {
        const StorageResource* storage = find_storage(effect_, effect_.tokens[token].text);
        return storage && names_global(effect_, effect_.functions[call.caller], token) ? storage : nullptr;
    }

    void method(const Call& call, const Token& name) const {
        const StorageResource* storage = call.name_token >= 2 ? resource_at(call, call.name_token - 2) : nullptr;
        if (!storage) return;
        if (name.is("IncrementCounter") || name.is("DecrementCounter"))
            error("PG047", name.at,
                  quoted(name) +
                      " is not supported, since buffers have no counter; count with InterlockedAdd in a "
                      "RWStructuredBuffer<uint>");
        else if (name.is("InterlockedCompareStore"))
            error("PG047", name.at, "'InterlockedCompareStore' is not supported; write InterlockedCompareExchange");
        else if ((name.text.starts_with("Store") || name.text.starts_with("Interlocked")) && !is_writable(*storage))
            read_only(*storage, name.at);
    }

    void read_only(const StorageResource& storage, Location at) const {
        error("PG047", at,
              "'" + std::string(storage.name) + "' is a " + std::string(storage.type) +
                  " and cannot be written; declare it as RW" + std::string(storage.type));
    }

    void interlocked(const Call& call, const Token& name) const {
        const TokenRange target = call.arguments.empty() ? TokenRange{} : call.arguments.front();
        if (target.empty()) return;  // glslang reports the number of arguments
        const Token& first = effect_.tokens[target.begin];
        if (const StorageResource* storage = resource_at(call, target.begin)) {
            if (!is_writable(*storage)) read_only(*storage, first.at);
            const ImageFormat format = texel_format(effect_, *storage);
            if (is_image(*storage) && format != ImageFormat::R32i && format != ImageFormat::R32ui)
                error("PG047", first.at,
                      quoted(name) + " needs texels of r32i or r32ui; declare '" + std::string(storage->name) +
                          "' as " + std::string(storage->type) + "<int> or " + std::string(storage->type) +
                          "<uint>, without another image format");
            return;
        }
        const bool shared = std::any_of(effect_.globals.begin(), effect_.globals.end(), [&](const Variable& global) {
            return global.qualifiers.groupshared && global.name == first.text;
        });
        if (!shared || !names_global(effect_, effect_.functions[call.caller], target.begin))
            error("PG047", first.at,
                  quoted(name) + " needs a groupshared variable or an element of a RW resource, not '" +
                      text_of(effect_, target) + "'; name one in the call");
    }

    void argument(const Call& call, const Function& callee, const Variable& parameter, TokenRange range) const {
        if (!parameter.qualifiers.in || !parameter.qualifiers.out || range.size() < 2) return;
        const StorageResource* storage = resource_at(call, range.begin);
        if (storage && is_image(*storage) && effect_.tokens[range.begin + 1].is("["))
            error("PG047", effect_.tokens[range.begin].at,
                  "a texel of '" + std::string(storage->name) + "' cannot be the inout parameter '" +
                      std::string(parameter.name) + "' of '" + std::string(callee.name) +
                      "'; copy it into a variable, and back after the call");
    }

    const ParsedEffect& effect_;
    const Sources& sources_;
    Diagnostics& diagnostics_;
};

}  // namespace

const StorageResource* find_storage(const ParsedEffect& effect, std::string_view name) {
    for (const StorageResource& storage : effect.storages)
        if (storage.name == name) return &storage;
    return nullptr;
}

bool is_writable(const StorageResource& storage) {
    return d3d9::find_storage_type(storage.type)->writable;
}

ImageFormat texel_format(const ParsedEffect& effect, const StorageResource& storage) {
    if (!is_image(storage)) return ImageFormat::None;
    if (storage.format) {
        const d3d9::ImageFormatRow* row = d3d9::find_image_format(storage.format->name);
        return row ? row->format : ImageFormat::None;
    }
    const auto type = numeric_type(effect, storage.element);
    return type ? element_format(*type) : ImageFormat::None;
}

void check_storage(const ParsedEffect& effect, const Sources& sources, const std::vector<Call>& calls,
                   Diagnostics& diagnostics) {
    const StorageChecker checker(effect, sources, diagnostics);
    for (const StorageResource& storage : effect.storages) checker.declaration(storage);
    for (const Function& function : effect.functions) checker.body(function);
    for (const Call& call : calls) checker.call(call);
}

}  // namespace permgen

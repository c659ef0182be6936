#include "lower/check_storage.h"

#include <algorithm>

#include "d3d9/storage_types.h"
#include "front/parse_cursor.h"
#include "front/report.h"
#include "lower/lower_types.h"

namespace permgen {
namespace {

constexpr int max_struct_depth = 16;

bool is_image(const StorageResource& storage) {
    return d3d9::find_storage_type(storage.type)->kind == ResourceKind::StorageImage;
}

class Checker {
public:
    Checker(const ParsedEffect& effect, const Sources& sources, Diagnostics& diagnostics)
        : effect_(effect), sources_(sources), diagnostics_(diagnostics) {}

    void declaration(const StorageResource& storage) const {
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
        if (!structure || depth >= max_struct_depth)
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
    const auto type = numeric_type(effect, storage.element);
    if (!type || type->is_matrix || type->scalar == ScalarType::Bool || type->columns == 3) return ImageFormat::None;
    const bool is_float = type->scalar == ScalarType::Float;
    const bool is_int = type->scalar == ScalarType::Int;
    switch (type->columns) {
        case 1:
            return is_float ? ImageFormat::R32f : is_int ? ImageFormat::R32i : ImageFormat::R32ui;
        case 2:
            return is_float ? ImageFormat::Rg32f : is_int ? ImageFormat::Rg32i : ImageFormat::Rg32ui;
        default:
            return is_float ? ImageFormat::Rgba32f : is_int ? ImageFormat::Rgba32i : ImageFormat::Rgba32ui;
    }
}

void check_storage(const ParsedEffect& effect, const Sources& sources, const std::vector<Call>& calls,
                   Diagnostics& diagnostics) {
    const Checker checker(effect, sources, diagnostics);
    for (const StorageResource& storage : effect.storages) checker.declaration(storage);
    for (const Function& function : effect.functions) checker.body(function);
    for (const Call& call : calls) checker.call(call);
}

}  // namespace permgen

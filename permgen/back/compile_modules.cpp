#include "back/compile_modules.h"

#include <algorithm>
#include <cstring>

#include "back/check_interface.h"
#include "back/compile.h"
#include "back/compile_log.h"
#include "back/drop_unused.h"
#include "back/validate.h"

namespace permgen {
namespace {

void put(std::string& out, const void* data, std::size_t bytes) {
    const std::uint64_t size = bytes;
    out.append(reinterpret_cast<const char*>(&size), sizeof size);
    out.append(static_cast<const char*>(data), bytes);
}

/// The next piece, or an empty one if the text ends too early.
std::string_view take(std::string_view& in) {
    std::uint64_t size = 0;
    if (in.size() < sizeof size) return {};
    std::memcpy(&size, in.data(), sizeof size);
    in.remove_prefix(sizeof size);
    const std::string_view piece = in.substr(0, static_cast<std::size_t>(size));
    in.remove_prefix(piece.size());
    return piece;
}

Diagnostic about(const LoweredModule& module, std::string code, const std::string& what) {
    return {Severity::Error, std::move(code), module.place, "entry point '" + module.author_entry + "' " + what};
}

}  // namespace

std::string pack(const WorkerReply& reply) {
    std::string out;
    put(out, reply.code.data(), reply.code.size() * sizeof(std::uint32_t));
    put(out, reply.log.data(), reply.log.size());
    put(out, reply.invalid.data(), reply.invalid.size());
    return out;
}

WorkerReply unpack(const std::string& packed) {
    std::string_view in = packed;
    WorkerReply reply;
    const std::string_view code = take(in);
    reply.code.resize(code.size() / sizeof(std::uint32_t));
    if (!reply.code.empty()) std::memcpy(reply.code.data(), code.data(), reply.code.size() * sizeof(std::uint32_t));
    reply.log = take(in);
    reply.invalid = take(in);
    return reply;
}

void append_new(Diagnostics& diagnostics, Diagnostics more) {
    for (Diagnostic& candidate : more) {
        const bool known = std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& said) {
            return said.code == candidate.code && said.message == candidate.message &&
                   said.place.file == candidate.place.file && said.place.line == candidate.place.line &&
                   said.place.column == candidate.place.column;
        });
        if (!known) diagnostics.push_back(std::move(candidate));
    }
}

std::vector<CompiledModule> compile_modules(const Lowered& effect, int jobs, const WorkerLimits& limits,
                                            Diagnostics& diagnostics) {
    warm_up_compiler();
    const bool writes = std::any_of(effect.resources.begin(), effect.resources.end(),
                                    [](const LoweredResource& resource) { return resource.writable; });
    const auto results = run_workers(effect.modules.size(), jobs, limits, [&](std::size_t i) {
        const LoweredModule& module = effect.modules[i];
        CompileResult compiled = compile_hlsl(module.stage, module.entry, module.hlsl);
        WorkerReply reply{std::move(compiled.code), std::move(compiled.log), {}};
        if (writes && module.stage != Stage::Compute) reply.code = drop_unused_variables(reply.code);
        if (!reply.code.empty()) reply.invalid = validate_spirv(reply.code);
        return pack(reply);
    });

    std::vector<CompiledModule> modules(effect.modules.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
        const LoweredModule& module = effect.modules[i];
        if (results[i].end != WorkerEnd::Done) {
            append_new(diagnostics,
                       {about(module, "PG052",
                              "could not be compiled: the shader compiler " + describe_failure(results[i], limits) +
                                  "; look for a malformed construct in it or beside it, such as a parameter without "
                                  "a name or a case outside a switch")});
            continue;
        }
        WorkerReply reply = unpack(results[i].reply);
        Diagnostics said = read_compile_log(reply.log, module);
        const bool explained = has_errors(said);
        append_new(diagnostics, std::move(said));
        if (explained) continue;
        if (reply.code.empty()) {
            append_new(diagnostics, {about(module, "PG053", "was rejected by the shader compiler without a reason")});
            continue;
        }
        if (!reply.invalid.empty()) {
            append_new(diagnostics, {about(module, "PG054",
                                           "became invalid SPIR-V (" + reply.invalid +
                                               "); this is a fault of permgen, please report it")});
            continue;
        }
        ReflectResult reflected = reflect(reply.code);
        if (!reflected.reflection) {
            append_new(diagnostics, {about(module, "PG055", "cannot be described: " + reflected.reason)});
            continue;
        }
        Diagnostics mismatches = check_interface(module, effect.resources, *reflected.reflection);
        if (mismatches.empty()) modules[i] = {std::move(reply.code), std::move(*reflected.reflection)};
        append_new(diagnostics, std::move(mismatches));
    }
    return modules;
}

}  // namespace permgen

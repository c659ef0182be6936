#include "back/freeze.h"

#include <map>

#include "back/compile_modules.h"
#include "back/specialize.h"
#include "back/validate.h"

namespace permgen {
namespace {

using Key = std::pair<int, std::vector<std::uint32_t>>;  // module, values of its switches

Key key_of(const LoweredShader& shader) {
    Key key{shader.module, {}};
    for (const LoweredConstant& constant : shader.constants) key.second.push_back(constant.bits);
    return key;
}

/// The distinct shaders, in order of first appearance.
struct Work {
    std::map<Key, std::size_t> index;
    std::vector<const LoweredShader*> shaders;

    void add(const LoweredShader& shader) {
        if (shader.module >= 0 && index.try_emplace(key_of(shader), shaders.size()).second) shaders.push_back(&shader);
    }
};

FrozenShader unpack_frozen(const WorkerResult& result, const WorkerLimits& limits, const LoweredShader& shader,
                           const LoweredModule& module, Diagnostics& diagnostics) {
    const auto fail = [&](const std::string& why) {
        diagnostics.push_back({Severity::Error, "PG057", shader.place,
                               "setting the switches of '" + module.author_entry + "' failed: " + why +
                                   "; this is a fault of permgen, please report it"});
        return FrozenShader{};
    };
    if (result.end != WorkerEnd::Done) return fail("SPIRV-Tools " + describe_failure(result, limits));
    WorkerReply reply = unpack(result.reply);
    if (reply.code.empty()) return fail(reply.log);
    if (!reply.invalid.empty()) return fail("the result is invalid: " + reply.invalid);
    ReflectResult reflected = reflect(reply.code);
    if (!reflected.reflection) return fail(reflected.reason);
    return {std::move(reply.code), std::move(*reflected.reflection)};
}

}  // namespace

std::vector<std::vector<BuiltPass>> freeze_passes(const Lowered& effect, const std::vector<CompiledModule>& modules,
                                                  int jobs, const WorkerLimits& limits, Diagnostics& diagnostics) {
    Work work;
    for (const LoweredTechnique& technique : effect.techniques)
        for (const LoweredPass& pass : technique.passes) {
            work.add(pass.vertex);
            work.add(pass.pixel);
            work.add(pass.compute);
        }
    const auto results = run_workers(work.shaders.size(), jobs, limits, [&](std::size_t i) {
        const LoweredShader& shader = *work.shaders[i];
        SpecializeResult frozen = specialize(modules[static_cast<std::size_t>(shader.module)].code, shader.constants);
        WorkerReply reply{std::move(frozen.code), std::move(frozen.reason), {}};
        if (!reply.code.empty()) reply.invalid = validate_spirv(reply.code);
        return pack(reply);
    });

    std::vector<FrozenShader> distinct;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const LoweredShader& shader = *work.shaders[i];
        const LoweredModule& module = effect.modules[static_cast<std::size_t>(shader.module)];
        distinct.push_back(unpack_frozen(results[i], limits, shader, module, diagnostics));
    }

    std::vector<std::vector<BuiltPass>> passes;
    for (const LoweredTechnique& technique : effect.techniques) {
        auto& built = passes.emplace_back();
        for (const LoweredPass& pass : technique.passes) {
            BuiltPass& out = built.emplace_back();
            if (pass.vertex.module >= 0) out.vertex = distinct[work.index.at(key_of(pass.vertex))];
            if (pass.pixel.module >= 0) out.pixel = distinct[work.index.at(key_of(pass.pixel))];
            if (pass.compute.module >= 0) out.compute = distinct[work.index.at(key_of(pass.compute))];
        }
    }
    return passes;
}

}  // namespace permgen

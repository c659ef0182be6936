#include "back/build_program.h"

#include <algorithm>

#include "back/compile_modules.h"
#include "back/freeze.h"
#include "back/link.h"
#include "common/names.h"

namespace permgen {
namespace {

void check_links(const Program& program, Diagnostics& diagnostics) {
    const Lowered& effect = program.effect;
    for (std::size_t t = 0; t < effect.techniques.size(); ++t)
        for (std::size_t p = 0; p < effect.techniques[t].passes.size(); ++p) {
            const LoweredPass& pass = effect.techniques[t].passes[p];
            if (pass.vertex.module < 0 || pass.pixel.module < 0) continue;
            append_new(diagnostics, check_link(pass, effect.modules[static_cast<std::size_t>(pass.vertex.module)],
                                               program.passes[t][p].vertex.reflection,
                                               effect.modules[static_cast<std::size_t>(pass.pixel.module)],
                                               program.passes[t][p].pixel.reflection));
        }
}

bool uses(const Reflection& reflection, const LoweredResource& resource) {
    return std::any_of(reflection.resources.begin(), reflection.resources.end(), [&](const ReflectedResource& used) {
        return used.set == resource.set && used.binding == resource.binding;
    });
}

void find_live(Program& program) {
    for (auto& technique : program.passes)
        for (BuiltPass& pass : technique)
            for (std::size_t i = 0; i < program.effect.resources.size(); ++i)
                if (uses(pass.vertex.reflection, program.effect.resources[i]) ||
                    uses(pass.pixel.reflection, program.effect.resources[i]) ||
                    uses(pass.compute.reflection, program.effect.resources[i]))
                    pass.live.push_back(i);
}

std::vector<ReflectedMember> members_of(const Reflection& reflection, const std::string& block) {
    std::vector<ReflectedMember> members;
    std::copy_if(reflection.members.begin(), reflection.members.end(), std::back_inserter(members),
                 [&](const ReflectedMember& member) { return member.block == block; });
    return members;
}

bool is_buffer(ResourceKind kind) {
    return kind == ResourceKind::UniformBuffer || kind == ResourceKind::StorageBuffer;
}

/// Sizes and members of the blocks and elements; they must agree in all modules.
void describe_blocks(Program& program, Diagnostics& diagnostics) {
    for (const LoweredResource& resource : program.effect.resources) {
        std::uint32_t size = 0;
        std::vector<ReflectedMember> members;
        for (std::size_t i = 0; is_buffer(resource.kind) && i < program.modules.size(); ++i) {
            const Reflection& reflection = program.modules[i].reflection;
            const auto used =
                std::find_if(reflection.resources.begin(), reflection.resources.end(),
                             [&](const ReflectedResource& candidate) { return candidate.name == resource.name; });
            if (used == reflection.resources.end()) continue;
            auto here = members_of(reflection, resource.name);
            if (size != 0 && (size != used->size || members != here))
                diagnostics.push_back({Severity::Error, "PG058", resource.place,
                                       resource_name(resource.kind, resource.dimension) + " '" + resource.name +
                                           "' is laid out differently in '" + program.effect.modules[i].author_entry +
                                           "'; this is a fault of permgen, please report it"});
            size = used->size;
            members = std::move(here);
        }
        program.resource_sizes.push_back(size);
        program.members.insert(program.members.end(), members.begin(), members.end());
    }
}

}  // namespace

std::optional<Program> build_program(Lowered effect, const BuildOptions& options, Diagnostics& diagnostics) {
    Program program;
    program.effect = std::move(effect);
    program.modules = compile_modules(program.effect, options.jobs, options.limits, diagnostics);
    if (has_errors(diagnostics)) return std::nullopt;
    program.passes = freeze_passes(program.effect, program.modules, options.jobs, options.limits, diagnostics);
    if (has_errors(diagnostics)) return std::nullopt;
    check_links(program, diagnostics);
    find_live(program);
    describe_blocks(program, diagnostics);
    if (has_errors(diagnostics)) return std::nullopt;
    return program;
}

}  // namespace permgen

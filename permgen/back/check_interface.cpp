#include "back/check_interface.h"

#include <algorithm>
#include <spirv/unified1/spirv.hpp>

#include "common/names.h"

namespace permgen {
namespace {

enum class Direction { In, Out };

struct Builtin {
    std::string_view semantic;  ///< without its index
    Stage stage;
    Direction direction;
    std::uint32_t kind;
};

constexpr Builtin builtins[] = {
    {"SV_POSITION", Stage::Vertex, Direction::Out, spv::BuiltInPosition},
    {"SV_POSITION", Stage::Pixel, Direction::In, spv::BuiltInFragCoord},
    {"SV_CLIPDISTANCE", Stage::Vertex, Direction::Out, spv::BuiltInClipDistance},
    {"SV_CLIPDISTANCE", Stage::Pixel, Direction::In, spv::BuiltInClipDistance},
    {"SV_CULLDISTANCE", Stage::Vertex, Direction::Out, spv::BuiltInCullDistance},
    {"SV_CULLDISTANCE", Stage::Pixel, Direction::In, spv::BuiltInCullDistance},
    {"SV_VERTEXID", Stage::Vertex, Direction::In, spv::BuiltInVertexIndex},
    {"SV_INSTANCEID", Stage::Vertex, Direction::In, spv::BuiltInInstanceIndex},
    {"PSIZE", Stage::Vertex, Direction::Out, spv::BuiltInPointSize},
    {"SV_ISFRONTFACE", Stage::Pixel, Direction::In, spv::BuiltInFrontFacing},
    {"SV_PRIMITIVEID", Stage::Pixel, Direction::In, spv::BuiltInPrimitiveId},
    {"SV_SAMPLEINDEX", Stage::Pixel, Direction::In, spv::BuiltInSampleId},
    {"SV_COVERAGE", Stage::Pixel, Direction::In, spv::BuiltInSampleMask},
    {"SV_COVERAGE", Stage::Pixel, Direction::Out, spv::BuiltInSampleMask},
    {"SV_DEPTH", Stage::Pixel, Direction::Out, spv::BuiltInFragDepth},
    {"SV_DISPATCHTHREADID", Stage::Compute, Direction::In, spv::BuiltInGlobalInvocationId},
    {"SV_GROUPTHREADID", Stage::Compute, Direction::In, spv::BuiltInLocalInvocationId},
    {"SV_GROUPID", Stage::Compute, Direction::In, spv::BuiltInWorkgroupId},
    {"SV_GROUPINDEX", Stage::Compute, Direction::In, spv::BuiltInLocalInvocationIndex},
};

std::string_view without_index(std::string_view semantic) {
    while (!semantic.empty() && semantic.back() >= '0' && semantic.back() <= '9') semantic.remove_suffix(1);
    return semantic;
}

class Checker {
public:
    Checker(const LoweredModule& module, Diagnostics& out) : module_(module), out_(out) {}

    void variables(const std::vector<LoweredAttribute>& intended, const std::vector<ReflectedVariable>& actual,
                   Direction direction) const;
    void resources(const std::vector<LoweredResource>& intended, const std::vector<ReflectedResource>& actual) const;
    void switches(const std::vector<ReflectedConstant>& actual) const;
    void entry(const Reflection& actual) const;

private:
    void fault(const SourceLocation& place, const std::string& what) const {
        out_.push_back({Severity::Error, "PG056", place.file.empty() ? module_.place : place,
                        "entry point '" + module_.author_entry + "': " + what +
                            "; the shader compiler changed its meaning; this is a fault of permgen, please report it"});
    }
    bool is_builtin(const LoweredAttribute& attribute, Direction direction, std::uint32_t kind) const {
        return attribute.builtin && std::any_of(std::begin(builtins), std::end(builtins), [&](const Builtin& builtin) {
                   return builtin.kind == kind && builtin.stage == module_.stage && builtin.direction == direction &&
                          builtin.semantic == without_index(attribute.semantic);
               });
    }

    const LoweredModule& module_;
    Diagnostics& out_;
};

void Checker::variables(const std::vector<LoweredAttribute>& intended, const std::vector<ReflectedVariable>& actual,
                        Direction direction) const {
    const std::string word = direction == Direction::In ? "input" : "output";
    for (const ReflectedVariable& variable : actual) {
        if (variable.builtin) {
            if (std::none_of(intended.begin(), intended.end(), [&](const LoweredAttribute& attribute) {
                    return is_builtin(attribute, direction, variable.builtin_kind);
                }))
                fault({}, word + " '" + variable.name + "' became a system value by mistake");
            continue;
        }
        const auto meant = std::find_if(intended.begin(), intended.end(), [&](const LoweredAttribute& attribute) {
            return !attribute.builtin && attribute.location == variable.location;
        });
        const std::string location = "location " + std::to_string(variable.location);
        if (meant == intended.end())
            fault({}, word + " '" + variable.name + "' is at " + location + " by mistake");
        else if (meant->components != variable.components || meant->type != variable.type)
            fault(meant->place, word + " " + meant->semantic + " at " + location + " is " +
                                    type_name(variable.type, variable.components) + ", but " +
                                    type_name(meant->type, meant->components) + " was intended");
    }
    for (const LoweredAttribute& attribute : intended) {
        const bool found = std::any_of(actual.begin(), actual.end(), [&](const ReflectedVariable& variable) {
            return variable.builtin ? is_builtin(attribute, direction, variable.builtin_kind)
                                    : !attribute.builtin && attribute.location == variable.location;
        });
        if (!found && direction == Direction::Out)
            fault(attribute.place, "output " + attribute.semantic + " is missing");
    }
}

void Checker::resources(const std::vector<LoweredResource>& intended,
                        const std::vector<ReflectedResource>& actual) const {
    for (const ReflectedResource& resource : actual) {
        const auto meant = std::find_if(intended.begin(), intended.end(), [&](const LoweredResource& candidate) {
            return candidate.set == resource.set && candidate.binding == resource.binding;
        });
        const std::string slot =
            "set " + std::to_string(resource.set) + ", binding " + std::to_string(resource.binding);
        if (meant == intended.end() || meant->name != resource.name)
            fault({}, "resource '" + resource.name + "' is at " + slot + " by mistake");
        else if (module_.stage != Stage::Compute && resource.writable)
            out_.push_back({Severity::Error, "PG048", module_.place,
                            "entry point '" + module_.author_entry + "' writes '" + resource.name + "', which a " +
                                std::string(stage_name(module_.stage)) +
                                " shader cannot do; compile it as a ComputeShader"});
        else if (meant->format != resource.format || meant->writable != resource.writable)
            fault(meant->place, "resource '" + resource.name + "' at " + slot + " has another format or access");
        else if (meant->kind != resource.kind || meant->dimension != resource.dimension)
            fault(meant->place, "resource '" + resource.name + "' at " + slot + " is a " +
                                    resource_name(resource.kind, resource.dimension) + ", but a " +
                                    resource_name(meant->kind, meant->dimension) + " was intended");
    }
}

void Checker::switches(const std::vector<ReflectedConstant>& actual) const {
    for (const ReflectedConstant& constant : actual)
        if (std::none_of(module_.axes.begin(), module_.axes.end(),
                         [&](const LoweredAxis& axis) { return axis.id == constant.id && axis.type == constant.type; }))
            fault({}, "specialization constant " + std::to_string(constant.id) + " was not intended");
    for (const LoweredAxis& axis : module_.axes)
        if (std::none_of(actual.begin(), actual.end(),
                         [&](const ReflectedConstant& constant) { return constant.id == axis.id; }))
            fault(axis.place, "switch '" + axis.name + "' did not become a specialization constant");
}

void Checker::entry(const Reflection& actual) const {
    if (actual.entry != module_.entry || actual.stage != module_.stage)
        fault({}, "its entry point became '" + actual.entry + "'");
    if (actual.group_size != module_.group_size) fault({}, "its thread group has another size");
}

}  // namespace

Diagnostics check_interface(const LoweredModule& module, const std::vector<LoweredResource>& resources,
                            const Reflection& actual) {
    Diagnostics diagnostics;
    const Checker checker(module, diagnostics);
    checker.entry(actual);
    checker.variables(module.inputs, actual.inputs, Direction::In);
    checker.variables(module.outputs, actual.outputs, Direction::Out);
    checker.resources(resources, actual.resources);
    checker.switches(actual.constants);
    return diagnostics;
}

}  // namespace permgen

#include "back/link.h"

#include <algorithm>

#include "common/names.h"

namespace permgen {
namespace {

std::string semantic_at(const std::vector<LoweredAttribute>& attributes, const ReflectedVariable& variable) {
    for (const LoweredAttribute& attribute : attributes)
        if (!attribute.builtin && attribute.location == variable.location) return attribute.semantic;
    return "'" + variable.name + "'";
}

std::string written_by(const LoweredModule& vertex) {
    std::string list;
    for (const LoweredAttribute& output : vertex.outputs)
        if (!output.builtin) list += (list.empty() ? "" : ", ") + output.semantic;
    return list.empty() ? "no varyings" : "only " + list;
}

}  // namespace

Diagnostics check_link(const LoweredPass& pass, const LoweredModule& vertex, const Reflection& vertex_actual,
                       const LoweredModule& pixel, const Reflection& pixel_actual) {
    Diagnostics diagnostics;
    for (const ReflectedVariable& input : pixel_actual.inputs) {
        if (input.builtin) continue;
        const std::string semantic = semantic_at(pixel.inputs, input);
        const auto output =
            std::find_if(vertex_actual.outputs.begin(), vertex_actual.outputs.end(),
                         [&](const ReflectedVariable& o) { return !o.builtin && o.location == input.location; });
        if (output == vertex_actual.outputs.end()) {
            diagnostics.push_back({Severity::Error, "PG060", pass.pixel.place,
                                   "'" + pixel.author_entry + "' reads " + semantic + ", but '" + vertex.author_entry +
                                       "' writes " + written_by(vertex) + "; write " + semantic +
                                       " in the vertex shader, or set the switches so that it is not read"});
        } else if (output->type != input.type || output->components < input.components) {
            diagnostics.push_back({Severity::Error, "PG061", pass.pixel.place,
                                   "'" + pixel.author_entry + "' reads " + semantic + " as " +
                                       type_name(input.type, input.components) + ", but '" + vertex.author_entry +
                                       "' writes it as " + type_name(output->type, output->components) +
                                       "; give both the same type"});
        }
    }
    return diagnostics;
}

}  // namespace permgen

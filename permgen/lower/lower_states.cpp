#include "lower/lower_states.h"

#include <algorithm>

#include "common/nearest.h"
#include "d3d9/states.h"
#include "front/parse_cursor.h"
#include "front/preprocess_expression.h"
#include "front/report.h"
#include "lower/state_value.h"

namespace permgen {
namespace {

using d3d9::Scope;
using d3d9::StateRow;
using d3d9::Support;

bool belongs(const StateRow& row, bool in_sampler) {
    return in_sampler ? row.scope == Scope::Sampler : true;
}

std::string unknown_name(std::string_view name, bool in_sampler) {
    std::vector<std::string_view> names;
    for (const StateRow& row : d3d9::states)
        if (belongs(row, in_sampler)) names.push_back(row.name);
    return "'" + std::string(name) + "' is not a " + (in_sampler ? "sampler " : "") + "state of Direct3D 9" +
           suggestion(name, names, "; did you mean '", "'?");
}

/// Whether the value has an effect when drawing.
bool takes_effect(const StateRow& row, const LoweredState& state, bool in_sampler) {
    if (!in_sampler && row.scope == Scope::Sampler) return false;
    if (row.support == Support::Fixed) return state.bits == row.fixed;
    if (row.support == Support::None) return false;
    const d3d9::NamedValue* named = row.kind == ValueKind::Enum ? d3d9::find_value(row, state.bits) : nullptr;
    return !named || named->drawn;
}

std::string fixed_word(const StateRow& row) {
    const d3d9::NamedValue* named = d3d9::find_value(row, row.fixed);
    return named ? std::string(named->name) : std::to_string(row.fixed);
}

std::string no_effect(const StateRow& row, const LoweredState& state, bool in_sampler) {
    const std::string assignment = "'" + state.name + " = " + state.value + "'";
    if (!in_sampler && row.scope == Scope::Sampler)
        return "'" + state.name + "' has no effect in a pass; write it into the sampler's sampler_state";
    if (row.support == Support::Fixed)
        return assignment + " is not drawn: the renderer refuses a " + (in_sampler ? "sampler" : "pass") +
               " with it; write " + fixed_word(row) + " or remove it";
    if (row.support == Support::None)
        return "'" + state.name + "' has no effect here; remove it, or implement it in the shader";
    return assignment + " is not drawn: Direct3D 9 has this value, and the renderer refuses it; write another";
}

}  // namespace

StateChecker::StateChecker(const ParsedEffect& effect, const Sources& sources, Diagnostics& diagnostics)
    : effect_(effect), sources_(sources), diagnostics_(diagnostics) {
    for (const Variable& global : effect.globals) declared_.insert(std::string(global.name));
    for (const ConstantBuffer& buffer : effect.constant_buffers)
        for (const Variable& member : buffer.members) declared_.insert(std::string(member.name));
}

void StateChecker::error(const char* code, Location at, std::string message) {
    report_error(diagnostics_, code, sources_.place(at), std::move(message));
}

void StateChecker::warn_once(const char* code, std::string_view state, Location at, std::string message) {
    if (warned_.insert(std::string(state)).second)
        report_warning(diagnostics_, code, sources_.place(at), std::move(message));
}

bool StateChecker::check(const StateAssignment& state, Where where, LoweredState& lowered) {
    const bool in_sampler = where == Where::Sampler;
    const std::string_view name = effect_.tokens[state.range.begin].text;
    const StateRow* row = d3d9::find_state(name);
    if (!row || !belongs(*row, in_sampler)) {
        error("PG043", state.at,
              row ? "'" + std::string(row->name) + "' is not a sampler state; write it into a pass"
                  : unknown_name(name, in_sampler));
        return false;
    }
    lowered.id = row->id;
    lowered.name = row->name;
    lowered.value = state.value;
    if (!state.index.empty()) {
        const auto tokens = std::span(effect_.tokens).subspan(state.index.begin, state.index.size());
        const auto index = tokens.size() == 1 ? integer_literal(tokens.front().text) : std::nullopt;
        constexpr std::int64_t max_index = 255;
        if (row->scope == Scope::Pass || in_sampler || !index || *index < 0 || *index > max_index) {
            error("PG043", tokens.front().at,
                  row->scope == Scope::Pass || in_sampler
                      ? "'" + lowered.name + "' takes no index here; write " + lowered.name + " = ..."
                      : "the index of '" + lowered.name + "' is a literal from 0 to 255");
            return false;
        }
        lowered.index = static_cast<std::uint32_t>(*index);
        lowered.name += '[' + std::to_string(lowered.index) + ']';
    }

    const auto tokens = std::span<const Token>(effect_.tokens).subspan(state.words.begin, state.words.size());
    StateValue value = read_state_value(*row, tokens);
    // A parameter's name may replace a literal.
    if (value.at && declared_.contains(std::string(value.at->text))) value = {ValueKind::Expression, 0, {}, nullptr};
    if (!value.problem.empty()) {
        error("PG044", value.at->at, value.problem);
        return false;
    }
    lowered.kind = value.kind;
    lowered.bits = value.bits;
    // Names of declarations keep their case.
    if ((row->kind == ValueKind::Object || value.kind == ValueKind::Expression) && tokens.size() == 1)
        lowered.value = tokens.front().text;
    if (value.kind == ValueKind::Expression && row->support != Support::None)
        warn_once("PG046", row->name, tokens.front().at,
                  "the value of '" + lowered.name +
                      "' is not a literal; permgen does not compute it, and the renderer refuses it; write a literal");
    else if (!takes_effect(*row, lowered, in_sampler))
        warn_once("PG045", row->name, state.at, no_effect(*row, lowered, in_sampler));
    return true;
}

std::vector<LoweredState> StateChecker::check_all(const std::vector<StateAssignment>& states, Where where) {
    std::vector<LoweredState> lowered;
    for (const StateAssignment& state : states) {
        LoweredState next;
        if (!check(state, where, next)) continue;
        std::erase_if(lowered, [&](const LoweredState& earlier) { return earlier.name == next.name; });
        lowered.push_back(std::move(next));
    }
    return lowered;
}

std::vector<LoweredState> StateChecker::pass_states(const std::vector<StateAssignment>& states) {
    return check_all(states, Where::Pass);
}

std::vector<LoweredState> StateChecker::sampler_states(const std::vector<StateAssignment>& states) {
    return check_all(states, Where::Sampler);
}

}  // namespace permgen

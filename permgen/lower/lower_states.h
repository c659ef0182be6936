// State assignments, checked against Direct3D 9's table: names, values, support.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "front/effect.h"
#include "lower/lowered.h"

namespace permgen {

/// Checks the states of one effect. One object for the whole effect, since a warning about a state is given once.
class StateChecker {
public:
    StateChecker(const ParsedEffect& effect, const Sources& sources, Diagnostics& diagnostics);

    /// In the author's order. As in D3DX, the later of two settings of a state replaces the earlier.
    std::vector<LoweredState> pass_states(const std::vector<StateAssignment>& states);
    std::vector<LoweredState> sampler_states(const std::vector<StateAssignment>& states);

private:
    enum class Where { Pass, Sampler };

    std::vector<LoweredState> check_all(const std::vector<StateAssignment>& states, Where where);
    bool check(const StateAssignment& state, Where where, LoweredState& lowered);
    void error(const char* code, Location at, std::string message);
    void warn_once(const char* code, std::string_view state, Location at, std::string message);

    const ParsedEffect& effect_;
    const Sources& sources_;
    Diagnostics& diagnostics_;
    std::set<std::string> declared_;  ///< names of parameters, which a value may contain
    std::set<std::string, std::less<>> warned_;
};

}  // namespace permgen

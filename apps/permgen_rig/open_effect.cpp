#include "open_effect.h"

namespace tyndall::rig {

OpenEffect::OpenEffect(const permgen::Effect& effect, const std::function<bool(const permgen::Resource&)>& canBeBound)
    : original_(effect), tables_(effect) {
    for (const permgen::Resource& resource : effect.resources)
        if (canBeBound(resource)) live_.push_back(&resource);
    for (const permgen::Technique& technique : effect.techniques) {
        passes_.emplace_back(technique.passes.begin(), technique.passes.end());
        for (permgen::Pass& pass : passes_.back()) pass.live = live_;
    }
    for (std::size_t i = 0; i < passes_.size(); ++i) techniques_.push_back({effect.techniques[i].name, passes_[i]});
    tables_.techniques = techniques_;
}

const permgen::Technique& OpenEffect::counterpart(const permgen::Technique& technique) const {
    return techniques_[static_cast<std::size_t>(&technique - original_.techniques.data())];
}

}  // namespace tyndall::rig

// The same effect, as if every resource that can be bound were live: so that what permgen says is dead can be bound
// too, changed, and seen to change nothing.
#pragma once

#include <permgen/tables.h>

#include <functional>
#include <vector>

namespace tyndall::rig {

class OpenEffect {
public:
    /// `effect` must outlive it.
    OpenEffect(const permgen::Effect& effect, const std::function<bool(const permgen::Resource&)>& canBeBound);
    OpenEffect(const OpenEffect&) = delete;
    OpenEffect& operator=(const OpenEffect&) = delete;

    const permgen::Effect& tables() const { return tables_; }
    /// This effect's counterpart of one of the original's techniques.
    const permgen::Technique& counterpart(const permgen::Technique& technique) const;

private:
    const permgen::Effect& original_;
    std::vector<const permgen::Resource*> live_;
    std::vector<std::vector<permgen::Pass>> passes_;
    std::vector<permgen::Technique> techniques_;
    permgen::Effect tables_;
};

}  // namespace tyndall::rig

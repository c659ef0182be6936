// Which lights may be added up in one target.
#pragma once

#include <tyndall/plan.h>

namespace tyndall {

/// Puts every drawn light of the plan into a group. `lights`: as given to plan().
void formGroups(Plan& plan, std::span<const Light> lights);

}  // namespace tyndall

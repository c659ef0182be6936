// What takes the place of terms that are not drawn.
#pragma once

#include <tyndall/terms.h>

#include <glm/glm.hpp>

namespace tyndall {

/// The factor that replaces each term: 1 for terms that are drawn.
struct StandIns : PerTerm<glm::dvec3> {
    StandIns() { values.fill(glm::dvec3(1.0)); }
};

}  // namespace tyndall

// The runtime's own effects, compiled by permgen: `effect` of each in tyndall::effects::slices, ::composite
// and ::shadow_map. A program that compiles slices.fx itself must use another namespace.
#pragma once

#include <composite.fx.h>
#include <shadow_map.fx.h>
#include <slices.fx.h>

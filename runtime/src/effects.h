// The runtime's own effects, compiled by permgen: tyndall::slices, tyndall::composite, tyndall::shadow_map,
// each with `effect`.
#pragma once

#include <composite.fx.h>
#include <shadow_map.fx.h>
#include <slices.fx.h>

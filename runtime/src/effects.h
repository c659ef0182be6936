// The runtime's own effects, compiled by permgen: `effect` of each in tyndall::effects::slices, ::raycast,
// ::raycast_compute, ::composite, ::shadow_map and ::shadow_hierarchy. A program that compiles one of them itself must
// use another namespace.
#pragma once

#include <composite.fx.h>
#include <raycast.fx.h>
#include <raycast_compute.fx.h>
#include <shadow_hierarchy.fx.h>
#include <shadow_map.fx.h>
#include <slices.fx.h>

/* SPDX-License-Identifier: MIT */
/* The first stage of sure_spawn once more, compiled for processors that multiply and add in one: an
 * exact product is two operations there (numbers/error_free.h), not seventeen. Same points. */
#include "../stages/hits/surface.h"
#include "box/box_spawn.h"
#include "cone/cone_spawn.h"
#include "cylinder/cylinder_spawn.h"
#include "planar/planar_spawn.h"
#include "sphere/sphere_spawn.h"

#define plane_spawn_quick planar_spawn_quick
#define disc_spawn_quick planar_spawn_quick

#define QUICK(shape, SHAPE) shape##_spawn_quick,
spawning *const spawn_quick_fused[SURE_SHAPES] = {SURE_EACH_SHAPE(QUICK)};

/* SPDX-License-Identifier: MIT */
/* The first stage of sure_spawn on a sphere. */
#pragma once

#include "../../stages/hits/spawn_quick.h"
#include "../capped/axial_polish.h"
#include "sphere_filter.h"

/* 2 F = |p|^2 - r^2 */
static inline surface sphere_surface(const line_point *line, const sure_sphere *sphere)
{
    polish_point p = seen_from(&sphere->centre, line);
    dd xy = dd_add_loosely(dd_square(NULL, p.x), dd_square(NULL, p.y));
    dd rr = two_product(sphere->radius, sphere->radius);
    double f = remainder_of(dd_add_loosely(xy, dd_square(NULL, p.z)), dd_negate(NULL, rr));
    sure_vec3 n = heads_of(&p);
    double size = measure_of(n) + QUICK_SPAWN_SHARE * p.most;
    return (surface){.f = 0.5 * f,
                     .f_error = 0.5 * SURE_SPHERE_RESIDUAL_BOUND * size * p.most,
                     .n = n,
                     .grain = QUICK_SPAWN_SHARE * p.most,
                     .bend = 1,
                     .beyond = beyond(size) | beyond(p.most),
                     .level = {.axis = -1}};
}

SPAWN_QUICK(sphere_spawn_quick, sphere_surface(&line, shape))

/* SPDX-License-Identifier: MIT */
/* The first stage of sure_spawn on a box. */
#pragma once

#include "../planar/planar_spawn.h"
#include "box_filter.h"

/* How far a coordinate is from the faces, less what is rounded. */
static inline double room_along(dd x, double low, double high, double most)
{
    double p = x.head + x.tail;
    return filter_lesser(p - low, high - p) - QUICK_SPAWN_SHARE * (most + fabs(low) + fabs(high));
}

/* F = N.p; the other functions are those of the other faces. */
static inline surface box_surface(const line_point *line, const sure_box *s, sure_part part)
{
    int face = box_face(part);
    sure_vec3 normal = box_outward(part);
    double x = room_along(line->x, s->low.x, s->high.x, line->most);
    double y = room_along(line->y, s->low.y, s->high.y, line->most);
    double z = room_along(line->z, s->low.z, s->high.z, line->most);
    double thick = box_place(s, face | 1) - box_place(s, face & ~1);
    surface f = flat_surface(line, face % 2 ? &s->high : &s->low, &normal);
    f.room = filter_lesser(filter_lesser(face < 2 ? thick : x, face / 2 == 1 ? thick : y),
                           face > 3 ? thick : z);
    f.steep = 1;
    return f;
}

SPAWN_QUICK(box_spawn_quick, box_surface(&line, shape, hit->part))

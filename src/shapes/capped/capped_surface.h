/* What cylinder and cone share of their surface. Both structs are the base's centre, the axis's
 * other end and the radius. */
#ifndef SHAPES_CAPPED_SURFACE_H
#define SHAPES_CAPPED_SURFACE_H

#include "../../stages/hits/normal.h"
#include "../bounds.h"
#include "capped_spawn.h"

static inline bool capped_plane(const void *shape, sure_part part, part_plane *plane)
{
    const sure_vec3 *ends = shape;
    bool top = part == SURE_PART_TOP;
    *plane = (part_plane){ends[!top], ends[top], ends[top]};
    return part != SURE_PART_WALL;
}

static inline bool capped_has_inside(const void *shape)
{
    const double *radius = (const double *)shape + 6;
    return !is_zero_bits(*radius);
}

/* The row's spawn_quick, from <shape>_surface for the wall. */
#define CAPPED_SPAWN(solid, solid_has_top)                                                         \
    SPAWN_QUICK(spawn_on_wall, solid##_surface(&line, shape))                                      \
    static bool spawn_quick(const sure_ray *ray, const void *shape, const sure_hit *hit,           \
                            double side, sure_vec3 *origin, sure_hit *nearer)                      \
    {                                                                                              \
        const sure_##solid *s = shape;                                                             \
        const sure_vec3 *ends = shape;                                                             \
        bool top = solid_has_top && hit->part == SURE_PART_TOP;                                    \
        if (hit->part == SURE_PART_WALL)                                                           \
            return spawn_on_wall(ray, shape, hit, side, origin, nearer);                           \
        return spawn_on_cap(ray, hit, side, &ends[!top], &ends[top], s->radius, origin, nearer);   \
    }

#endif

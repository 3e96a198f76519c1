/* SPDX-License-Identifier: MIT */
/* The endless walls of cylinder and cone for exact, in exact numbers from the start. */
#include "capped_stages.h"

#include <surehit/cone_wall.h>
#include <surehit/cylinder_wall.h>

/* Is the body, which is negative inside, so before the point? */
static bool comes_out(exact_context *c, const line_coefficients *l, end_kind at)
{
    int leading = exact_sign(c, l->a);
    if (at == END_START)
        return false;
    if (at == END_MORE)
        return leading > 0;
    return leading < 0 || (leading == 0 && exact_sign(c, l->b) > 0);
}

/* Of the solid that has the wall. */
static sure_status wall_hit(const sure_ray *ray, const void *shape, const shape_row *solid,
                            const shape_row *wall, sure_hit *hit)
{
    exact_arena room;
    exact_context c = exact_start(&room);
    line_coefficients l;
    tagged_end first;
    bool is_last;
    if (shape_check(solid, ray, shape) != SURE_FIELD_NONE)
        return SURE_INVALID;
    if (line_hit(&c, ray, wall, shape, &l, &first, &is_last) != SURE_HIT)
        return SURE_MISS;
    double t = round_t(&c, ray, &l, first.at);
    *hit = (sure_hit){t, first.at == END_START ? 0 : half_ulp(t), SURE_PART_WALL,
                      comes_out(&c, &l, first.at)};
    return SURE_HIT;
}

#define WALL_HIT(shape)                                                                            \
    sure_status sure_##shape##_wall_hit_exact(const sure_ray *ray, const sure_##shape *of,         \
                                              sure_hit *hit)                                       \
    {                                                                                              \
        static const shape_row wall = {.exact_interval = shape##_wall_exact};                      \
        return wall_hit(ray, of, &shape##_row, &wall, hit);                                        \
    }
WALL_HIT(cone)
WALL_HIT(cylinder)

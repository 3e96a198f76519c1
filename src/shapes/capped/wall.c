/* SPDX-License-Identifier: MIT */
/* The endless walls of cylinder and cone for exact, in exact numbers from the start. */
#include "capped_stages.h"

#include <surehit/cone_wall.h>
#include <surehit/cylinder_wall.h>

#include <assert.h>

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

/* The body's sign at t_min; one that the line misses is not worked out (wall_exact). */
static int wall_side(const sure_ray *ray, const void *shape, const shape_row *wall)
{
    exact_arena room;
    exact_context c = exact_start(&room);
    line_coefficients l;
    (void)wall->exact_interval(&c, ray, shape, &l);
    if (exact_sign(&c, l.a) > 0 && exact_sign(&c, l.quarter) < 0)
        return 1;
    exact t = exact_of(&c, ray->t_min), rising = exact_add(&c, exact_mul(&c, l.a, t), l.b);
    exact body = exact_add(&c, exact_mul(&c, exact_add(&c, rising, l.b), t), l.c);
    return exact_sign(&c, body);
}

#define WALL_EXACT(shape)                                                                          \
    static const shape_row shape##_wall = {.exact_interval = shape##_wall_exact};                  \
    sure_status sure_##shape##_wall_hit_exact(const sure_ray *ray, const sure_##shape *of,         \
                                              sure_hit *hit)                                       \
    {                                                                                              \
        return wall_hit(ray, of, &shape##_row, &shape##_wall, hit);                                \
    }                                                                                              \
    int sure_##shape##_wall_side_exact(const sure_ray *ray, const sure_##shape *of)                \
    {                                                                                              \
        assert(shape_check(&shape##_row, ray, of) == SURE_FIELD_NONE);                             \
        return wall_side(ray, of, &shape##_wall);                                                  \
    }
WALL_EXACT(cone)
WALL_EXACT(cylinder)

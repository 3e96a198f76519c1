/* SPDX-License-Identifier: MIT */
/* The notes' parts of cylinder and cone, heights, walls, their normals and end points, projections
 * of their derivations, and the bracket of a hit: against the reference where there is one, and by
 * laws. */

#include "hard_points.h"
#include "shape_bytes.h"
#include "surroundings.h"
#include "tiers.h"
#ifndef FUZZ_WITHOUT_REFERENCE
#include "part_check.h"
#endif

#include <surehit/cone_height.h>
#include <surehit/cylinder_height.h>

FUZZ_TARGET("parts", fuzz_mutate_doubles)

typedef struct {
    sure_case of;
    sure_vec3 point;
    double height;
} part_question;

static int certain(const part_question *q)
{
    const sure_object *solid = &q->of.object;
    return is_pointed(solid) ? sure_cone_height_certain(q->point, &solid->as.cone)
                             : sure_cylinder_height_certain(q->point, &solid->as.cylinder);
}

/* In another environment, and by the height's Law 6 in a mirror. */
static void check_laws(part_question *q, int environment)
{
    sure_cylinder *s = &q->of.object.as.cylinder; /* a cone has its numbers in the same places */
    int given = certain(q);
    surroundings_set(environment);
    int again = certain(q);
    surroundings_set(0);
    expect(again == given, "another height in another environment");
    sure_vec3 *const places[] = {&q->point, &s->base, &s->top};
    for (int i = 0; i < 3; i++)
        *places[i] = (sure_vec3){places[i]->y, -places[i]->x, places[i]->z};
    expect(certain(q) == given, "Law 6: another height in a mirror");
}

#ifndef FUZZ_WITHOUT_REFERENCE
static void promised(const char *broken)
{
    expect(!broken, broken);
}

static void check_truth(const part_question *q, bool valid, int which)
{
    const sure_object *solid = &q->of.object;
    const sure_ray *ray = &q->of.ray;
    part_unrounded unused = {0};
    if (which == 0)
        promised(wall_hit_broken(ray, solid, &unused));
    if (which == 1)
        promised(end_points_broken(solid->shape, ray->origin, ray->direction,
                                   solid->as.cylinder.radius, q->height, &unused));
    if (which == 2 && all_finite(q->point) && all_finite(ray->direction))
        promised(vectors_broken(q->point, ray->direction, &unused));
    unsigned long asked = 0;
    if (which == 3 && sure_object_check(ray, solid) == SURE_FIELD_NONE)
        promised(bracket_broken(ray, solid, &asked));
    if (which > 3 && valid)
        promised(which % 2 ? height_broken(solid, q->point, &unused)
                           : wall_normal_broken(solid, q->point, &unused));
}
#else
static void check_truth(const part_question *q, bool valid, int which)
{
    (void)q, (void)valid, (void)which;
}
#endif

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    uint8_t how = fuzz_byte(&bytes), which = fuzz_byte(&bytes) % 8;
    uint64_t draws = fuzz_draws(data, size);
    part_question q;
    if (!fuzz_case(&bytes, how & 1 ? SURE_SHAPE_CONE : SURE_SHAPE_CYLINDER, &q.of))
        return false;
    fuzz_cheapen(&q.of, &draws);
    q.height = fuzz_shaped_double(&bytes);
    const sure_ray any = {{0, 0, 0}, {1, 0, 0}, 0, 0};
    bool valid = sure_object_check(&any, &q.of.object) == SURE_FIELD_NONE;
    q.point = how & 2 || !valid ? fuzz_vector(&bytes, fuzz_shaped_double)
                                : hard_point(&q.of.object, fuzz_u64(&bytes));
    valid = valid && all_finite(q.point);
    fuzz_ask("%s\npoint %a %a %a height %a", case_text(&q.of), q.point.x, q.point.y, q.point.z,
             q.height);
    check_truth(&q, valid, which);
    if (valid)
        check_laws(&q, (int)(draws % SURROUNDINGS));
    return true;
}

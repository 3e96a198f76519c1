/* SPDX-License-Identifier: MIT */
/* The plane for certain and exact: what it gives to the stages. */
#include "../planar/planar_stages.h"
#include "../stable.h"
#include "plane.h"
#include "plane_filter.h"

/* e = 0: the whole line when h = 0, nothing otherwise. */
static tagged_interval exact_interval(exact_context *c, const sure_ray *ray, const void *shape,
                                      line_coefficients *l)
{
    const sure_plane *plane = shape;
    planar_line at = planar_line_of(c, ray, plane->point, plane->normal, l);
    if (exact_sign(c, l->speed) != 0)
        return interval_point((tagged_end){END_BASE, SURE_PART_SURFACE});
    return exact_sign(c, at.h) == 0 ? interval_endless(SURE_PART_SURFACE) : interval_empty();
}

const shape_row plane_row = {
    .info = {.name = "plane",
             .solid = 0,
             .bounded = 0,
             .numbers = 6,
             .field_count = 2,
             .part_count = 1,
             .fields = {{SURE_FIELD_POINT, SURE_KIND_POINT, DOUBLES_BEFORE(sure_plane, point)},
                        {SURE_FIELD_NORMAL, SURE_KIND_NORMAL, DOUBLES_BEFORE(sure_plane, normal)}},
             .parts = {SURE_PART_SURFACE}},
    .shape = SURE_SHAPE_PLANE,
    .filter = plane_filter,
    .steps = 1,
    .exact_interval = exact_interval,
    .round_normal = planar_round_normal,
    .surface = &plane_surface_row,
};

sure_status sure_plane_hit_certain(const sure_ray *ray, const sure_plane *plane, sure_hit *hit)
{
    const flat_decision said = plane_decide(ray, plane);
    filter_verdict verdict = flat_hit(&said, hit);
    if (verdict == FILTER_UNCERTAIN)
        return said.level ? stages_certain_rest(ray, plane, hit, &plane_row)
                          : stages_certain_hit(ray, plane, hit, &plane_row);
    return verdict == FILTER_INTERVAL ? SURE_HIT : SURE_MISS;
}

STAGES_QUESTIONS(plane)

/* Where the first stage is uncertain stable answers as textbook has it. */
static span plane_guess(const sure_ray *ray, const void *shape)
{
    plane_line line = plane_line_from(ray, shape);
    return plane_line_span(&line);
}

STABLE_QUESTIONS(plane)

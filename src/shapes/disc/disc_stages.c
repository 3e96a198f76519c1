/* SPDX-License-Identifier: MIT */
/* The disc for certain and exact: what it gives to the stages. */
#include "../planar/planar_stages.h"
#include "../stable.h"
#include "disc.h"
#include "disc_filter.h"

#define NUMBER exact
#include "../sphere/sphere_tmpl.h"

/* A line in the disc's plane is cut by the circle as by a sphere. */
static tagged_interval edge_on(exact_context *c, const planar_line *at, exact r,
                               line_coefficients *l)
{
    l->a = vector_square_exact(c, at->d);
    l->quarter = difference_exact(c, sphere_discriminant_exact(c, l->a, at->d, at->m, r));
    if (exact_sign(c, l->quarter) < 0)
        return interval_empty();
    l->factor = exact_of(c, 1);
    l->b = vector_dot_exact(c, at->m, at->d);
    l->c = difference_exact(c, sphere_body_exact(c, at->m, r));
    return interval_along((tagged_end){END_LESS, SURE_PART_SURFACE},
                          (tagged_end){END_MORE, SURE_PART_SURFACE}, SURE_PART_SURFACE);
}

/* The plane's point, if it is not too far from the centre. */
static tagged_interval exact_interval(exact_context *c, const sure_ray *ray, const void *shape,
                                      line_coefficients *l)
{
    const sure_disc *disc = shape;
    planar_line at = planar_line_of(c, ray, disc->centre, disc->normal, l);
    exact r = exact_of(c, disc->radius);
    if (exact_sign(c, l->speed) == 0)
        return exact_sign(c, at.h) == 0 ? edge_on(c, &at, r, l) : interval_empty();
    two_terms_exact rim = disc_rim_exact(c, l->speed, at.h, at.m, at.d, r);
    if (exact_sign(c, difference_exact(c, rim)) < 0)
        return interval_empty();
    return interval_point((tagged_end){END_BASE, SURE_PART_SURFACE});
}

const shape_row disc_row = {
    .info = {.name = "disc",
             .solid = 0,
             .bounded = 1,
             .numbers = 7,
             .field_count = 3,
             .part_count = 1,
             .fields = {{SURE_FIELD_CENTRE, SURE_KIND_POINT, DOUBLES_BEFORE(sure_disc, centre)},
                        {SURE_FIELD_NORMAL, SURE_KIND_NORMAL, DOUBLES_BEFORE(sure_disc, normal)},
                        {SURE_FIELD_RADIUS, SURE_KIND_RADIUS, DOUBLES_BEFORE(sure_disc, radius)}},
             .parts = {SURE_PART_SURFACE}},
    .shape = SURE_SHAPE_DISC,
    .filter = disc_filter,
    .steps = 1,
    .exact_interval = exact_interval,
    .round_normal = planar_round_normal,
    .surface = &disc_surface_row,
};

sure_status sure_disc_hit_certain(const sure_ray *ray, const sure_disc *disc, sure_hit *hit)
{
    const flat_decision said = disc_decide(ray, disc);
    filter_verdict verdict = flat_hit(&said, hit);
    if (verdict == FILTER_UNCERTAIN)
        return said.level ? stages_certain_rest(ray, disc, hit, &disc_row)
                          : stages_certain_hit(ray, disc, hit, &disc_row);
    return verdict == FILTER_INTERVAL ? SURE_HIT : SURE_MISS;
}

STAGES_QUESTIONS(disc)

/* Where the first stage is uncertain stable answers as textbook has it, but for what is certain on
 * which side of the rim the crossing lies. */
static span disc_guess(const sure_ray *ray, const void *shape)
{
    const sure_disc *disc = shape;
    filter_interval unused;
    filter_verdict verdict = disc_filter(ray, disc, &unused);
    plane_line line = plane_line_from(ray, shape);
    return verdict == FILTER_INTERVAL ? plane_line_span(&line)
           : verdict == FILTER_MISS   ? span_empty()
                                      : disc_line_span(&line, (real)disc->radius);
}

STABLE_QUESTIONS(disc)

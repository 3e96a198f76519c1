/* SPDX-License-Identifier: MIT */
/* On a plane of normal N through Q, t* = N.(Q - o) / N.d. On a curved part, where
 * f(t) = F(m + t d) = a t^2 + 2 b t + c is 0 at t*, f(t*) = f(t) + (t* - t) (f'(t) + a (t* - t)),
 * and so
 *
 *     t* = t - f(t) / (f'(t) + x),  |x| <= |a| t_error
 *
 * exactly: a step of Newton's method from the hit's t, whose error is counted to the slope. One is
 * enough from a t whose doubles are fine beside the object. Where they are not, as seen from afar,
 * or where t is known badly, it takes more, each from where the last one led: a place between
 * doubles. Where the slope is not certain (the ray touches, or lies in the plane or in the wall)
 * nothing is. */
#include "../../numbers/environment.h"
#include "../stages.h"
#include "beyond.h"
#include "normal.h"

#include <surehit/bounds.h>

#include <assert.h>

#define NUMBER ddb

static ddb planar_t(number_context *c, const sure_ray *ray, const part_plane *plane)
{
    vector normal = vector_between(c, plane->from, plane->to);
    ddb height = vector_dot(c, normal, vector_between(c, ray->origin, plane->at));
    return ddb_div(c, height, vector_dot(c, normal, vector_of(c, ray->direction)));
}

/* t* - at for a place of the ray that is off by `off` at most. */
static ddb curved_step(number_context *c, const shape_row *row, const sure_ray *ray,
                       const void *shape, ddb at, double off)
{
    c->uncertain |= !is_finite_bits(at.hi) || !is_finite_bits(off);
    part_slope p = surface_slope(c, row, ray, shape, at);
    ddb slope = ddb_add(c, p.half_slope, p.half_slope), bend = ddb_add(c, p.bend.more, p.bend.less);
    slope.error += (fabs(bend.hi + bend.lo) + bend.error) * off * DDB_SLACK;
    return ddb_negate(c, ddb_div(c, p.f, slope));
}

/* On to where the step leads: is another one from there worth it? */
static bool goes_on(number_context *c, ddb step, ddb *at, double *off)
{
    const ddb t = ddb_add(c, *at, step);
    const bool halves = t.error < *off / 2;
    *at = (ddb){t.hi, t.lo, ddb_floor_of(t.hi) + ddb_floor_of(t.lo)};
    *off = t.error;
    return halves;
}

/* Of a plane across a coordinate axis all points have that coordinate of Q, exactly. */
static void set_level(vector *p, const part_plane *plane)
{
    vector level = vector_of(NULL, plane->at);
    ddb *coordinate = surface_level(p, plane->from, plane->to);
    if (coordinate)
        *coordinate = *surface_level(&level, plane->from, plane->to);
}

static NOT_INLINED bool rounds_to(ddb x, double *rounded)
{
    *rounded = 0;
    return ddb_is_zero(x) || ddb_rounds_to(x, rounded);
}

static bool point_rounds(const vector *p, sure_vec3 *point)
{
    return rounds_to(p->x, &point->x) && rounds_to(p->y, &point->y) && rounds_to(p->z, &point->z);
}

bool interaction_point(const shape_row *row, const sure_ray *ray, const void *shape,
                       const sure_hit *hit, sure_vec3 *point)
{
    assert(environment_is_nearest());
    const sure_vec3 world = {0, 0, 0};
    part_plane plane;
    number_context c = {false};
    if (row->surface->plane && row->surface->plane(shape, hit->part, &plane)) {
        vector p = surface_point(&c, ray, world, planar_t(&c, ray, &plane));
        set_level(&p, &plane);
        return !c.uncertain && point_rounds(&p, point);
    }
    ddb at = ddb_of(&c, hit->t), step;
    double off = hit->t_error;
    do {
        step = curved_step(&c, row, ray, shape, at, off);
        vector p = surface_point_after(&c, ray, world, at, step);
        if (c.uncertain || point_rounds(&p, point))
            return !c.uncertain;
    } while (goes_on(&c, step, &at, &off));
    return false;
}

static vector unit(number_context *c, vector v)
{
    return vector_over_ddb(c, v, ddb_sqrt(c, vector_square(c, v)));
}

static bool component_as_wanted(ddb x, bool rounded, double *result)
{
    *result = ddb_is_zero(x) ? 0 : x.hi;
    return rounded ? rounds_to(x, result) : x.error + fabs(x.lo) <= SURE_NORMAL_ERROR / 2;
}

static bool normal_as_wanted(const vector *n, bool rounded, sure_vec3 *normal)
{
    return component_as_wanted(n->x, rounded, &normal->x) &&
           component_as_wanted(n->y, rounded, &normal->y) &&
           component_as_wanted(n->z, rounded, &normal->z);
}

bool interaction_normal(const shape_row *row, const sure_ray *ray, const void *shape,
                        const sure_hit *hit, bool rounded, sure_vec3 *normal)
{
    assert(environment_is_nearest());
    part_plane plane;
    if (row->surface->plane && row->surface->plane(shape, hit->part, &plane)) {
        number_context c = {false};
        vector n = unit(&c, vector_between(&c, plane.from, plane.to));
        return !c.uncertain && normal_as_wanted(&n, rounded, normal);
    }
    const sure_vec3 anchor = surface_anchor(row, shape);
    number_context c = {false};
    ddb at = ddb_of(&c, hit->t), step;
    double off = hit->t_error;
    do {
        step = curved_step(&c, row, ray, shape, at, off);
        if (c.uncertain)
            return false;
        vector p = surface_point_after(&c, ray, anchor, at, step);
        vector n = row->surface->unit_normal(&c, shape, p);
        if (!c.uncertain && normal_as_wanted(&n, rounded, normal))
            return true;
        c.uncertain = false;
    } while (goes_on(&c, step, &at, &off));
    return false;
}

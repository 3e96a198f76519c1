/* SPDX-License-Identifier: MIT */
/* On a plane of normal N through Q, t* = N.(Q - o) / N.d. On a curved part, where
 * f(t) = F(m + t d) = a t^2 + 2 b t + c is 0 at t*, f(t*) = f(t) + (t* - t) (f'(t) + a (t* - t)),
 * and so
 *
 *     t* = t - f(t) / (f'(t) + x),  |x| <= |a| t_error
 *
 * exactly: a step of Newton's method from the hit's t, whose error is counted to the slope. One is
 * enough from a t that is rounded correctly; from a worse one it may take more, each from where the
 * last one led. Where the slope is not certain (the ray touches, or lies in the plane or in the
 * wall) nothing is. */
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

static ddb curved_t(number_context *c, const shape_row *row, const sure_ray *ray, const void *shape,
                    const sure_hit *hit)
{
    ddb t = ddb_of(c, hit->t);
    c->uncertain |= !is_finite_bits(hit->t) || !is_finite_bits(hit->t_error);
    part_slope at = surface_slope(c, row, ray, shape, hit->t);
    ddb slope = ddb_add(c, at.half_slope, at.half_slope),
        bend = ddb_add(c, at.bend.more, at.bend.less);
    slope.error += (fabs(bend.hi + bend.lo) + bend.error) * hit->t_error * DDB_SLACK;
    return ddb_sub(c, t, ddb_div(c, at.f, slope));
}

/* t is where a step from `at` led: is another one worth it? Then that is `at`. */
static bool goes_on(ddb t, sure_hit *at)
{
    const sure_hit from = *at;
    at->t = t.hi;
    at->t_error = (fabs(t.lo) + t.error) * DDB_SLACK;
    return from.t_error > half_ulp(from.t) && at->t_error < from.t_error / 2;
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
    sure_hit at = *hit;
    part_plane plane;
    bool planar = row->surface->plane && row->surface->plane(shape, hit->part, &plane);
    ddb t;
    do {
        number_context c = {false};
        t = planar ? planar_t(&c, ray, &plane) : curved_t(&c, row, ray, shape, &at);
        if (c.uncertain)
            return false;
        vector p = surface_point(&c, ray, world, t);
        if (planar)
            set_level(&p, &plane);
        if (point_rounds(&p, point))
            return true;
    } while (!planar && goes_on(t, &at));
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
    sure_hit at = *hit;
    part_plane plane;
    ddb t;
    if (row->surface->plane && row->surface->plane(shape, hit->part, &plane)) {
        number_context c = {false};
        vector n = unit(&c, vector_between(&c, plane.from, plane.to));
        return !c.uncertain && normal_as_wanted(&n, rounded, normal);
    }
    do {
        number_context c = {false};
        t = curved_t(&c, row, ray, shape, &at);
        if (c.uncertain)
            return false;
        vector p = surface_point(&c, ray, surface_anchor(row, shape), t);
        vector n = row->surface->unit_normal(&c, shape, p);
        if (!c.uncertain && normal_as_wanted(&n, rounded, normal))
            return true;
    } while (goes_on(t, &at));
    return false;
}

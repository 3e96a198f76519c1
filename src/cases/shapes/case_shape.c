/* SPDX-License-Identifier: MIT */
#include "case_shape.h"

#include "../regimes/camera_pictures.h"

#include <math.h>

#define DECLARE(name, NAME) extern const case_shape case_##name;
#define ROW(name, NAME) [SURE_SHAPE_##NAME] = &case_##name,
SURE_EACH_SHAPE(DECLARE)
static const case_shape *const rows[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};

const case_shape *case_shape_of(sure_shape shape)
{
    return rows[shape];
}

bool case_shape_has(sure_shape shape, unsigned what)
{
    unsigned inside = sure_shape_info_of(shape)->solid ? CASE_HAS_INSIDE : 0;
    unsigned lacking = what & ~(rows[shape]->has | inside);
    return lacking == 0 || (lacking == CASE_HAS_PICTURE && camera_shows(shape)); /* slow */
}

sure_mat3 turn_any(const double q[4])
{
    double a = q[0], b = q[1], c = q[2], d = q[3];
    return (sure_mat3){{
        {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
        {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
        {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d},
    }};
}

void points_on_axis(const layout *lay, sure_vec3 point[2])
{
    point[0] = (sure_vec3){0, 0, 0};
    point[1] = (sure_vec3){0, 0, lay->h};
}

double reach_of_rim(const layout *lay)
{
    return sqrt(lay->r * lay->r + lay->h * lay->h);
}

/* Points and directions that are drawn. */

sure_vec3 random_in_circle(rng *g, double r, double z)
{
    for (;;) {
        double x = rng_between(g, -1, 1);
        double y = rng_between(g, -1, 1);
        double square = x * x + y * y;
        if (square > 0 && square < 1)
            return (sure_vec3){r * x, r * y, z};
    }
}

/* Of radius 1, up to rounding. */
static sure_vec3 random_on_circle(rng *g)
{
    sure_vec3 out;
    double square;
    do {
        out = random_in_circle(g, 1, 0);
        square = out.x * out.x + out.y * out.y;
    } while (square < 0x1p-10);
    return scaled(1 / sqrt(square), out);
}

sure_vec3 random_in_base(const layout *lay, rng *g)
{
    return random_in_circle(g, lay->r, 0);
}

static bool random_is_top(const layout *lay, rng *g)
{
    return case_shape_has(lay->shape, CASE_HAS_TWO_CAPS) && rng_chance(g, 1, 2);
}

double random_cap(const layout *lay, rng *g)
{
    return random_is_top(lay, g) ? lay->h : 0;
}

boundary_point random_cap_point(const layout *lay, rng *g)
{
    bool top = random_is_top(lay, g);
    return (boundary_point){random_in_circle(g, lay->r, top ? lay->h : 0), {0, 0, top ? 1 : -1}};
}

/* The radius of the body at height f h. */
static double radius_at(const layout *lay, double f)
{
    return case_shape_has(lay->shape, CASE_HAS_APEX) ? lay->r * (1 - f) : lay->r;
}

sure_vec3 random_in_body(const layout *lay, rng *g)
{
    double f = rng_between(g, 0, 1);
    return random_in_circle(g, radius_at(lay, f), f * lay->h);
}

boundary_point random_boundary_point(const layout *lay, rng *g)
{
    if (!rng_chance(g, 1, 2))
        return random_cap_point(lay, g);
    bool narrows = case_shape_has(lay->shape, CASE_HAS_APEX);
    double slant = sqrt(lay->h * lay->h + lay->r * lay->r);
    double normal_out = narrows ? lay->h / slant : 1, normal_up = narrows ? lay->r / slant : 0;
    double f = rng_between(g, 0, 1), r = radius_at(lay, f);
    sure_vec3 out = random_on_circle(g);
    return (boundary_point){{r * out.x, r * out.y, f * lay->h},
                            {normal_out * out.x, normal_out * out.y, normal_up}};
}

bool moved_flat(const double *object, const movement *how, double *to)
{
    moved_axis axis;
    if (how->along == 0)
        return true;
    if (!moved_axis_of(object, 3, object + 3, how->along, &axis))
        return false;
    moved_point(object, moved_farther(how->along, 2 * axis.rounding), axis.unit, to);
    return true;
}

void tangent_at_rim(layout *lay, rng *g)
{
    lay->r = random_whole_size(g);
    lay->p.x = lay->r;
    lay->d.y = rng_signed(g, WAY_BITS);
}

double random_side_height(double h, rng *g)
{
    switch (rng_integer(g, 0, 7)) {
    case 0: return 0;
    case 1: return h;
    case 2: return -rng_whole(g, SIZE_BITS);
    case 3: return h + rng_whole(g, SIZE_BITS);
    default: return floor(rng_between(g, 0, h));
    }
}

double random_within(double r, rng *g)
{
    return rng_chance(g, 1, 8) ? r : floor(rng_between(g, 0, r));
}

void on_cap(layout *lay, rng *g)
{
    lay->p.x = random_within(lay->r, g);
    lay->p.z = random_cap(lay, g);
}

/* A boundary point that is entered. */

sure_vec3 random_entering(rng *g, sure_vec3 outwards)
{
    for (;;) {
        sure_vec3 v = rng_whole_vector(g, 2);
        double along_normal = dot(v, outwards);
        if (along_normal != 0)
            return scaled(along_normal < 0 ? 1 : -1, v);
    }
}

void enter_flat(layout *lay, bool top, double x, rng *g)
{
    lay->p.x = x;
    lay->p.z = top ? lay->h : 0;
    lay->d = random_entering(g, (sure_vec3){0, 0, top ? 1 : -1});
}

void enter_cap(layout *lay, rng *g)
{
    bool top = random_is_top(lay, g);
    enter_flat(lay, top, floor(rng_between(g, 0, lay->r)), g);
}

void enter_side(layout *lay, rng *g)
{
    lay->p.x = lay->r;
    lay->p.z = floor(rng_between(g, 0, lay->h));
    lay->d = random_entering(g, (sure_vec3){1, 0, 0});
}

/* Where a ray crosses, as double finds it. */

static void add_crossing(crossings *all, double t)
{
    if (t > 0)
        all->t[all->count++] = t;
}

void cross_flat(crossings *all, const layout *lay, double height)
{
    if (lay->d.z == 0)
        return;
    double t = (height - lay->p.z) / lay->d.z;
    sure_vec3 at = sum_of(lay->p, t, lay->d);
    if (case_shape_has(lay->shape, CASE_HAS_NO_END) || at.x * at.x + at.y * at.y <= lay->r * lay->r)
        add_crossing(all, t);
}

void cross_base(crossings *all, const layout *lay)
{
    cross_flat(all, lay, 0);
}

static void cross_side(crossings *all, const layout *lay, double t)
{
    double z = lay->p.z + t * lay->d.z;
    if (!case_shape_has(lay->shape, CASE_HAS_FLAT) || (z >= 0 && z <= lay->h))
        add_crossing(all, t);
}

void cross_round(crossings *all, const layout *lay, double a, double half_b, double c)
{
    double discriminant = half_b * half_b - a * c;
    if (discriminant < 0)
        return;
    double far = half_b < 0 ? sqrt(discriminant) - half_b : -sqrt(discriminant) - half_b;
    if (a != 0)
        cross_side(all, lay, far / a);
    cross_side(all, lay, c / far);
}

across across_axis(const layout *lay)
{
    sure_vec3 o = lay->p, d = lay->d;
    return (across){d.x * d.x + d.y * d.y, o.x * d.x + o.y * d.y, o.x * o.x + o.y * o.y};
}

/* SPDX-License-Identifier: MIT */
/* interval, midpoint: a hit at the very end of the range, or between two doubles. */
#include "../shapes/case_shape.h"

#include <math.h>

/* One end of the range, or both, within `steps` doubles of t. */
static void range_within(layout *lay, rng *g, double t, int steps)
{
    double end = step_ulps(t, rng_integer(g, -steps, steps));
    lay->t_min = 0;
    lay->t_max = HUGE_VAL;
    int which = rng_integer(g, 0, 8);
    if (which >= 4)
        lay->t_min = end;
    if (which <= 4)
        lay->t_max = end;
}

/* t* in whole numbers: the placed t is exact. */
static sure_case interval_at_whole_t(sure_shape shape, rng *g)
{
    layout lay = surface_layout(shape, g);
    lay.d = rng_whole_vector(g, WAY_BITS);
    lay.t = rng_whole(g, TIME_BITS);
    range_within(&lay, g, lay.t, 1);
    return place_exactly(&lay, g);
}

/* t* mostly irrational, within an ulp or two of what double finds: the numbers are so small that
 * all but the last steps are exact. */
static sure_case interval_at_rounded_t(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape, .r = rng_whole(g, 4)};
    if (case_shape_has(shape, CASE_HAS_HEIGHT))
        lay.h = rng_whole(g, 4);
    sure_vec3 through = {0, 0, floor(lay.h / 2)};
    through.x = trunc(rng_between(g, -lay.r, lay.r) / 2); /* inside the cone, too */
    lay.p.x = rng_offset(g, 6);
    lay.p.y = rng_offset(g, 6);
    lay.p.z = rng_signed(g, 6); /* off the plane and the disc */
    lay.d = difference_of(through, lay.p);
    if (lay.d.x == 0 && lay.d.y == 0 && lay.d.z == 0)
        lay.d.z = 1;
    crossings all = {.count = 0};
    case_shape_of(shape)->cross(&all, &lay);
    double t = all.count == 0 ? 1 : all.t[rng_integer(g, 0, all.count - 1)];
    range_within(&lay, g, t, 2);
    return place_exactly(&lay, g);
}

sure_case make_interval(sure_shape shape, rng *g)
{
    return rng_chance(g, 1, 2) ? interval_at_whole_t(shape, g) : interval_at_rounded_t(shape, g);
}

/* The height is a multiple of 2^LOW_BITS. */
#define LOW_BITS 10

double random_step_height(rng *g)
{
    return ldexp(rng_whole(g, 6), LOW_BITS);
}

/* A point p of the boundary in whole numbers, with a direction that enters there. */
static layout entering_layout(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape, .r = random_whole_size(g)};
    if (case_shape_has(shape, CASE_HAS_HEIGHT))
        lay.h = random_step_height(g);
    const case_shape *row = case_shape_of(shape);
    bool side = !row->enter_cap || (row->enter_side && rng_chance(g, 1, 2));
    (side ? row->enter_side : row->enter_cap)(&lay, g);
    return lay;
}

/* t* = odd 2^exponent, where doubles are multiples of 2^(exponent + 1). */
typedef struct {
    int64_t odd;
    int exponent;
} midpoint;

static midpoint random_midpoint(rng *g)
{
    uint64_t random = rng_bits(g);
    int64_t normal = (int64_t)(random >> 11 | (uint64_t)1 << 53 | 1);
    switch (rng_integer(g, 0, 7)) {
    case 0: /* subnormal, of any number of digits */
        return (midpoint){(int64_t)rng_whole(g, 53) | 1, -1075};
    case 1: /* between 0 and the least; between the largest subnormal and the least normal */
        return (midpoint){rng_chance(g, 1, 2) ? 1 : ((int64_t)1 << 53) - 1, -1075};
    case 2: /* between the largest double and infinity */
        return (midpoint){((int64_t)1 << 54) - 1, 970};
    case 3: /* between a power of two and the double below or above it */
        return (midpoint){((int64_t)1 << 53) + (rng_chance(g, 1, 2) ? 1 : ((int64_t)1 << 53) - 1),
                          rng_integer(g, -70, -40)};
    case 4: return (midpoint){normal, rng_integer(g, -1075, 969)};
    default: return (midpoint){normal, rng_integer(g, -70, -40)};
    }
}

/* The range open, or with an end at a neighbour of t*. */
static void range_at_midpoint(sure_case *c, rng *g, midpoint t)
{
    double below = ldexp((double)((t.odd - 1) / 2), t.exponent + 1);
    double above = ldexp((double)((t.odd + 1) / 2), t.exponent + 1);
    int which = rng_integer(g, 0, 9);
    c->ray.t_max = which <= 2 ? below : which <= 4 ? above : HUGE_VAL;
    c->ray.t_min = which == 4 || which == 5 ? below : which == 6 && isfinite(above) ? above : 0;
}

/* Row i of turn times v, in whole numbers. */
static int64_t whole_dot(const sure_vec3 *row, sure_vec3 v)
{
    return (int64_t)row->x * (int64_t)v.x + (int64_t)row->y * (int64_t)v.y +
           (int64_t)row->z * (int64_t)v.z;
}

/* One coordinate of the way from the ray's start to the frame's origin, of up to 62 digits, is
 * shared between the two points: its low digits go to the start, the rest to the object. */
typedef struct {
    int64_t start, object;
} ends;

static ends split(int64_t way, rng *g)
{
    int64_t unit = (int64_t)1 << LOW_BITS;
    int64_t low = (way % unit + unit) % unit;
    int64_t move = (int64_t)rng_offset(g, 40) * unit;
    return (ends){move - low, move + way - low};
}

/* Moves a case that was placed with the frame's origin in the world's, so that the ray is at lay->p
 * at t = t.odd, in the units of the layout. */
static void move_apart(sure_case *c, rng *g, const layout *lay, const pose *where, midpoint t)
{
    for (int i = 0; i < 3; i++) {
        const sure_vec3 *row = &where->turn.row[i];
        ends e = split(t.odd * whole_dot(row, lay->d) - whole_dot(row, lay->p), g);
        *case_number(c, AT_O + i) = ldexp((double)e.start, where->scale);
        for (int k = AT_OBJECT + i; k < case_numbers(c->object.shape); k += 3)
            if (is_coordinate(c->object.shape, k))
                *case_number(c, k) += ldexp((double)e.object, where->scale);
    }
}

sure_case make_midpoint(sure_shape shape, rng *g)
{
    layout lay = entering_layout(shape, g);
    double q[4] = {rng_integer(g, 1, 2)};
    for (int i = 1; i < 4; i++)
        q[i] = rng_integer(g, -2, 2);
    midpoint t = random_midpoint(g);
    pose where = pose_turned(shape, q);
    where.scale = t.exponent / 2 - rng_integer(g, 20, 40);
    where.d_scale = where.scale - t.exponent;
    where.n_scale = rng_integer(g, -20, 20);
    sure_case c = place(&lay, &where);
    move_apart(&c, g, &lay, &where, t);
    range_at_midpoint(&c, g, t);
    /* To one side by as little as there is: the start's coordinates are the small ones. */
    if (rng_chance(g, 1, 2))
        step_start(&c, g);
    return c;
}

/* SPDX-License-Identifier: MIT */
/* typical, inside, far, huge, tiny, nonunit, needle, coin, scaled_neighbour: what is large and what
 * is small. */
#include "../../numbers/places.h"
#include "../shapes/case_shape.h"

#include <float.h>
#include <math.h>

/* The ray comes along `unit` from `distance` before `target`, `speed` a unit of t. */
static void aim(layout *lay, sure_vec3 target, sure_vec3 unit, double distance, double speed)
{
    lay->p = target;
    lay->d = scaled(speed, unit);
    lay->t = distance / speed;
}

/* Past the object at 2^-6 .. 4 of its radius: of a solid along a plane that touches it, moved out;
 * of a disc through its plane. */
static void pass(layout *lay, rng *g, double distance, double speed)
{
    boundary_point at = case_shape_of(lay->shape)->boundary(lay, g);
    double off = lay->r * rng_magnitude(g, -6, 2);
    if (case_shape_has(lay->shape, CASE_HAS_INSIDE)) {
        sure_vec3 unit, n = at.normal;
        double part; /* of unit, along n */
        do {
            unit = rng_unit(g);
            part = dot(unit, n);
        } while (part * part > 0.5);
        unit = sum_of(unit, -part, n);
        aim(lay, sum_of(at.p, off, n), unit, distance / sqrt(1 - part * part), speed);
    } else {
        double from_centre = sqrt(at.p.x * at.p.x + at.p.y * at.p.y);
        double farther = (lay->r + off) / from_centre;
        sure_vec3 target = {farther * at.p.x, farther * at.p.y, 0};
        aim(lay, target, rng_unit(g), distance, speed);
    }
}

/* A ray from outside, `distance` before the object: in half of draws it meets it, else it passes
 * beside it, or (a plane, which has no beside) has it behind. */
static void random_ray_from_outside(layout *lay, rng *g, double distance)
{
    double speed = rng_magnitude(g, -10, 10);
    bool meets = rng_chance(g, 1, 2);
    if (meets || case_shape_has(lay->shape, CASE_HAS_NO_END)) {
        sure_vec3 target = case_shape_of(lay->shape)->inner(lay, g);
        aim(lay, target, rng_unit(g), meets ? distance : -distance, speed);
    } else {
        pass(lay, g, distance, speed);
    }
    range_usual(lay, g, fabs(lay->t));
}

static void random_ray_from_inside(layout *lay, rng *g)
{
    double speed = rng_magnitude(g, -10, 10);
    sure_vec3 start = case_shape_of(lay->shape)->inner(lay, g);
    aim(lay, start, rng_unit(g), 0, speed);
    range_usual(lay, g, case_shape_of(lay->shape)->reach(lay) / speed);
}

static layout typical_layout(sure_shape shape, rng *g)
{
    layout lay = random_body(shape, g, -10, 10);
    bool solid = case_shape_has(shape, CASE_HAS_INSIDE);
    if (solid && rng_chance(g, 1, 10)) {
        random_ray_from_inside(&lay, g);
    } else {
        double distance = rng_magnitude(g, -10, 10);
        random_ray_from_outside(
            &lay, g, solid ? 2 * case_shape_of(shape)->reach(&lay) + distance : distance);
    }
    return lay;
}

sure_case make_typical(sure_shape shape, rng *g)
{
    layout lay = typical_layout(shape, g);
    return place_generally(&lay, g, 10);
}

/* The range against the far boundary, at s: where inside is not enough. */
static void range_inside(layout *lay, rng *g, double s)
{
    double off = rng_sign(g) * 0x1p-50;
    off *= rng_magnitude(g, 0, 49);
    int kind = rng_integer(g, 0, 7);
    lay->t_min = kind == 3 ? s * (1 + off) : 0;
    lay->t_max = kind <= 2 ? s * (1 + off) : kind == 4 ? s * rng_between(g, 0, 1) : HUGE_VAL;
}

sure_case make_inside(sure_shape shape, rng *g)
{
    layout lay = random_body(shape, g, -10, 10);
    sure_vec3 middle = {0, 0, lay.h / 4};
    boundary_point from = case_shape_of(shape)->boundary(&lay, g);
    boundary_point to = case_shape_of(shape)->boundary(&lay, g);
    /* The start: the middle, close to the boundary, or between. */
    double out = rng_chance(g, 1, 16)  ? 0
                 : rng_chance(g, 1, 2) ? 1 - rng_magnitude(g, -20, -2)
                                       : rng_between(g, 0, 1);
    sure_vec3 start = sum_of(middle, out, difference_of(from.p, middle));
    double speed = rng_magnitude(g, -10, 10);
    lay.p = start;
    lay.d = scaled(speed, difference_of(to.p, start));
    lay.t = 0;
    range_inside(&lay, g, 1 / speed);
    return place_generally(&lay, g, 10);
}

/* Moves the world so that the ray starts at its origin, as in a picture. */
static void start_at_origin(sure_case *c)
{
    for (int i = AT_OBJECT; i < case_numbers(c->object.shape); i++)
        if (is_coordinate(c->object.shape, i))
            *case_number(c, i) -= *case_number(c, AT_O + (i - AT_OBJECT) % 3);
    c->ray.origin = (sure_vec3){0, 0, 0};
}

sure_case make_far(sure_shape shape, rng *g)
{
    layout lay = random_body(shape, g, -10, 10);
    if (case_shape_has(shape, CASE_HAS_HEIGHT))
        lay.h = lay.r * rng_magnitude(g, 0, 3); /* so that its ends stay apart, far out */
    double distance = lay.r * rng_magnitude(g, 10, 50);
    if (case_shape_has(shape, CASE_HAS_NO_END))
        lay.r *= rng_magnitude(g, 0, 50); /* the plane is met far from its point, too */
    random_ray_from_outside(&lay, g, distance);
    pose where = pose_general(shape, g, 10);
    bool from_origin = rng_chance(g, 1, 2);
    sure_case c = place(&lay, &where);
    if (from_origin)
        start_at_origin(&c);
    return c;
}

/* All numbers are multiples of 2^grid and below 2^top in size; for zeros alone 0 and 0. */
typedef struct {
    int grid, top;
} extent;

static extent extent_of(sure_case c, number_kind which)
{
    extent e = {0, 0};
    const int count = case_numbers(c.object.shape);
    for (int i = 0, found = 0; i < count; i++) {
        if (case_number_kind(c.object.shape, i) != which)
            continue;
        const magnitude_parts number = parts_of(*case_number(&c, i));
        const uint64_t digits = number.mantissa;
        if (digits == 0)
            continue;
        int top = number.exponent + bits_in(digits);
        int grid = number.exponent + bits_in(digits & -digits) - 1;
        e.top = found == 0 || top > e.top ? top : e.top;
        e.grid = found++ == 0 || grid < e.grid ? grid : e.grid;
    }
    return e;
}

/* Every number times a power of two; t follows from lengths and direction. */
static void rescale(sure_case *c, int lengths, int direction, int normal)
{
    const int scale[] = {
        [IS_LENGTH] = lengths,
        [IS_STEP] = direction,
        [IS_NORMAL] = normal,
        [IS_TIME] = lengths - direction,
    };
    for (int i = 0; i < case_numbers(c->object.shape); i++) {
        double *number = case_number(c, i);
        *number = times_two_to(*number, scale[case_number_kind(c->object.shape, i)]);
    }
    c->ray.t_min = fmin(c->ray.t_min, DBL_MAX);
}

/* A small object seen from as far as can be: the ray goes exactly through the frame's origin, a
 * point of every object (of a sphere the centre), or away from it. */
static sure_case huge_contrast(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape, .t_max = HUGE_VAL};
    lay.r = rng_whole(g, 10);
    lay.h = rng_whole(g, 10);
    lay.d = rng_whole_vector(g, 10);
    lay.t = rng_sign(g);
    pose where = pose_exact(shape, g);
    where.move = (sure_vec3){0, 0, 0};
    where.scale = rng_integer(g, -990, 0);
    sure_case c = place(&lay, &where);
    int farther = rng_integer(g, 513, 900) - where.scale;
    for (int i = AT_O; i < AT_O + 3; i++)
        *case_number(&c, i) = times_two_to(*case_number(&c, i), farther);
    return c;
}

/* To a largest number just below 2^E, with 2^E a random one from 1e-300 to 1e300; or not at all. */
static int any_scale(const sure_case *c, number_kind which, rng *g)
{
    if (rng_chance(g, 1, 2))
        return 0;
    return rng_integer(g, -990, 996) - extent_of(*c, which).top;
}

sure_case make_huge(sure_shape shape, rng *g)
{
    if (rng_chance(g, 1, 4))
        return huge_contrast(shape, g);
    sure_case c = rng_chance(g, 1, 2) ? make_tangent(shape, g) : make_typical(shape, g);
    int lengths = rng_integer(g, 513, 996) - extent_of(c, IS_LENGTH).top;
    int direction = any_scale(&c, IS_STEP, g);
    int normal = any_scale(&c, IS_NORMAL, g);
    rescale(&c, lengths, direction, normal);
    return c;
}

/* What is exact stays so on the grid of the subnormals; the rest keeps enough digits to stay
 * valid. */
static int tiny_scale(const sure_case *c, number_kind which, bool exact, rng *g)
{
    extent e = extent_of(*c, which);
    return exact ? rng_integer(g, -1074, -1040) - e.grid : rng_integer(g, -1040, -512) - e.top;
}

sure_case make_tiny(sure_shape shape, rng *g)
{
    bool exact = rng_chance(g, 1, 2);
    sure_case c = exact ? make_tangent(shape, g) : make_typical(shape, g);
    int lengths = tiny_scale(&c, IS_LENGTH, exact, g);
    int direction = rng_chance(g, 1, 2) ? tiny_scale(&c, IS_STEP, exact, g) : 0;
    int normal = rng_chance(g, 1, 2) ? tiny_scale(&c, IS_NORMAL, exact, g) : 0;
    rescale(&c, lengths, direction, normal);
    return c;
}

/* 300 .. 498, up or down: to 1e150 and 1e-150. */
static int random_far_exponent(rng *g)
{
    int exponent = rng_integer(g, 300, 498);
    return rng_chance(g, 1, 2) ? exponent : -exponent;
}

sure_case make_nonunit(sure_shape shape, rng *g)
{
    layout lay = typical_layout(shape, g);
    pose where = pose_general(shape, g, 10);
    sure_kind second = field_at(shape, AT_OBJECT + 3)->kind;
    bool has_other = second == SURE_KIND_NORMAL || second == SURE_KIND_OTHER_POINT;
    bool other_than_d = has_other && rng_chance(g, 1, 2);
    if (other_than_d && case_shape_has(shape, CASE_HAS_HEIGHT)) {
        /* An axis so long that the object is a half-line, so short that it is a disc; the ray stays
         * at the base, which must be the world's origin for a short axis to exist. */
        lay.h = ldexp(lay.h, random_far_exponent(g));
        where.move = (sure_vec3){0, 0, 0};
    } else if (other_than_d) {
        where.n_scale = random_far_exponent(g);
    }
    if (!other_than_d || rng_chance(g, 1, 2))
        where.d_scale = random_far_exponent(g);
    return place(&lay, &where);
}

/* A point within `beside` radii of the axis in x and y, up to `beyond` heights beyond the ends. */
static sure_vec3 random_target(const layout *lay, rng *g, double beyond, double beside)
{
    sure_vec3 target;
    target.z = lay->h * rng_between(g, -beyond, 1 + beyond);
    target.x = beside * lay->r * rng_between(g, -1, 1);
    target.y = beside * lay->r * rng_between(g, -1, 1);
    return target;
}

static sure_case place_aimed(layout *lay, rng *g, sure_vec3 target, sure_vec3 unit)
{
    double distance = fmax(lay->r, lay->h) * rng_magnitude(g, -3, 3);
    aim(lay, target, unit, distance, rng_magnitude(g, -10, 10));
    range_usual(lay, g, lay->t);
    return place_generally(lay, g, 3);
}

/* h / r is 2^38 .. 2^42; the ray passes the needle's size away from its axis, a quarter of them
 * nearly along it. */
sure_case make_needle(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape, .h = rng_magnitude(g, -3, 3)};
    lay.r = lay.h / rng_magnitude(g, 38, 42);
    sure_vec3 target = random_target(&lay, g, 0.125, 1.5), unit = rng_unit(g);
    if (rng_chance(g, 1, 4)) {
        double off = 1 / rng_magnitude(g, 34, 44);
        unit = (sure_vec3){off * unit.x, off * unit.y, unit.z < 0 ? -1 : 1};
    }
    return place_aimed(&lay, g, target, unit);
}

/* r / h is 2^38 .. 2^42; half of the rays come nearly in the coin's plane. */
sure_case make_coin(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape, .r = rng_magnitude(g, -3, 3)};
    lay.h = lay.r / rng_magnitude(g, 38, 42);
    sure_vec3 target = random_target(&lay, g, 0.5, 1.25), unit = rng_unit(g);
    if (rng_chance(g, 1, 2))
        unit.z /= rng_magnitude(g, 34, 44);
    return place_aimed(&lay, g, target, unit);
}

/* Scaled first and moved by ulps then; scaled down no further than numbers stay normal, so that an
 * ulp is as small against them as ever. */
sure_case make_scaled_neighbour(sure_shape shape, rng *g)
{
    layout lay = touch_layout(shape, g);
    range_at_t(&lay, g);
    sure_case c = place_exactly(&lay, g);
    bool up = rng_chance(g, 1, 2);
    int top = up ? rng_integer(g, 640, 996) : rng_integer(g, -960, -700);
    int lengths = top - extent_of(c, IS_LENGTH).top;
    int direction = rng_chance(g, 1, 2) ? top - extent_of(c, IS_STEP).top : 0;
    rescale(&c, lengths, direction, 0);
    if (rng_chance(g, 1, 2))
        nudge(&c, g);
    return c;
}

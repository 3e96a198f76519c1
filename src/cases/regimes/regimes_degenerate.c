/* SPDX-License-Identifier: MIT */
/* degenerate: valid inputs that have lost a dimension or a sign, and every kind of invalid one. */
#include "../shapes/case_shape.h"

#include <math.h>

/* What can be wrong with one number, or with three at once. */
static double random_bad(rng *g)
{
    static const double bad[] = {NAN, HUGE_VAL, -HUGE_VAL};
    return bad[rng_integer(g, 0, 2)];
}

static double random_zero(rng *g)
{
    return rng_sign(g) * 0.0;
}

static void spoil_vector(double v[3], rng *g)
{
    int i = rng_integer(g, 0, 2);
    v[i] = random_bad(g);
}

/* top and apex: not finite, or the base, in which 0 and -0 are the same. d and the normals: not
 * finite, or zero. */
static void spoil_end(double end[3], const double base[3], rng *g)
{
    if (rng_chance(g, 1, 2)) {
        spoil_vector(end, g);
        return;
    }
    for (int i = 0; i < 3; i++)
        end[i] = base[i] == 0 ? random_zero(g) : base[i];
}

static const double zero[3];

/* The high corner: not a number, or below the low one, if by the least. */
static void spoil_high(double high[3], const double low[3], rng *g)
{
    int i = rng_integer(g, 0, 2);
    high[i] = rng_chance(g, 1, 2) ? (double)NAN : step_ulps(low[i], -1);
}

/* t_min and radius: not finite, or negative, if by the least. */
static void spoil_size(double *size, rng *g)
{
    if (rng_chance(g, 1, 2))
        *size = random_bad(g);
    else
        *size = rng_chance(g, 1, 2) ? -0x1p-1074 : -rng_magnitude(g, -10, 10);
}

/* t_max: not a number, or below t_min, if by the least. */
static void spoil_t_max(sure_ray *ray, rng *g)
{
    switch (rng_integer(g, 0, 3)) {
    case 0: ray->t_max = NAN; break;
    case 1: ray->t_max = -HUGE_VAL; break;
    case 2: ray->t_max = step_ulps(ray->t_min, -1); break;
    default:
        ray->t_min = rng_magnitude(g, -10, 10);
        ray->t_max = ray->t_min / 2;
        break;
    }
}

enum { RAY_FIELDS = 4 }; /* o, d, t_min, t_max; then those of the object */

static void spoil_object(sure_case *c, const sure_shape_field *field, rng *g)
{
    double *object = case_number(c, AT_OBJECT), *at = object + field->at;
    switch (field->kind) {
    case SURE_KIND_POINT: spoil_vector(at, g); break;
    case SURE_KIND_NORMAL: spoil_end(at, zero, g); break;
    case SURE_KIND_HIGH: spoil_high(at, object, g); break;
    case SURE_KIND_RADIUS: spoil_size(at, g); break;
    default: spoil_end(at, object, g);
    }
}

static void spoil_field(sure_case *c, int field, rng *g)
{
    switch (field) {
    case 0: spoil_vector(case_number(c, AT_O), g); break;
    case 1: spoil_end(case_number(c, AT_D), zero, g); break;
    case 2: spoil_size(&c->ray.t_min, g); break;
    case 3: spoil_t_max(&c->ray, g); break;
    default: spoil_object(c, &sure_shape_info_of(c->object.shape)->fields[field - RAY_FIELDS], g);
    }
}

/* One field wrong; in a third of draws up to three. */
static sure_case invalid_case(sure_shape shape, rng *g)
{
    sure_case c = rng_chance(g, 1, 2) ? make_typical(shape, g) : make_tangent(shape, g);
    int spoilt = rng_chance(g, 1, 3) ? rng_integer(g, 2, 3) : 1;
    for (int i = 0; i < spoilt; i++) {
        int last = RAY_FIELDS + sure_shape_info_of(shape)->field_count - 1;
        spoil_field(&c, rng_integer(g, 0, last), g);
    }
    return c;
}

/* A ray through, along or past what is left of the object without its radius: its axis or its
 * centre. */
static layout shrunken_layout(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape};
    if (case_shape_has(shape, CASE_HAS_HEIGHT)) {
        lay.h = random_whole_size(g);
        lay.p.z = floor(rng_between(g, -lay.h / 8, lay.h * 9 / 8));
    }
    lay.d = rng_whole_vector(g, WAY_BITS);
    if (!case_shape_has(shape, CASE_HAS_INSIDE) && rng_chance(g, 1, 4) &&
        (lay.d.x != 0 || lay.d.y != 0))
        lay.d.z = 0;
    if (rng_chance(g, 1, 8))
        lay.d = (sure_vec3){0, 0, rng_signed(g, WAY_BITS)};
    if (rng_chance(g, 1, 8))
        lay.p.x = rng_signed(g, SIZE_BITS);
    lay.t = rng_whole(g, TIME_BITS);
    if (rng_chance(g, 1, case_shape_has(shape, CASE_HAS_NO_END) ? 4 : 8))
        lay.t = -lay.t;
    return lay;
}

static sure_case shrunken_case(sure_shape shape, rng *g)
{
    layout lay = shrunken_layout(shape, g);
    sure_case c = place_at_t(&lay, pose_exact, 8, g);
    int count = case_numbers(shape);
    /* A radius of 0, -0 or, so far below the rest that its square is 0, the least ones. */
    if (field_at(shape, count - 1)->kind == SURE_KIND_RADIUS)
        *case_number(&c, count - 1) =
            rng_chance(g, 1, 2) ? random_zero(g) : ldexp(rng_whole(g, 40), -1074);
    for (int i = 0; i < count; i++) {
        double *number = case_number(&c, i);
        if (*number == 0 && rng_chance(g, 1, 2))
            *number = -*number;
    }
    return c;
}

sure_case make_degenerate(sure_shape shape, rng *g)
{
    return rng_chance(g, 1, 3) ? invalid_case(shape, g) : shrunken_case(shape, g);
}

/* degenerate: valid inputs that have lost a dimension or a sign, and every kind of invalid one. */
#include "../shapes/case_shape.h"

#include <math.h>

/* What can be wrong with one number, or with three at once. */
static double random_bad(rng *g)
{
    switch (rng_integer(g, 0, 2)) {
    case 0: return NAN;
    case 1: return HUGE_VAL;
    default: return -HUGE_VAL;
    }
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

/* top and apex: not finite, or the base, in which 0 and -0 are the same. */
void spoil_end(double end[3], const double base[3], rng *g)
{
    if (rng_chance(g, 1, 2)) {
        spoil_vector(end, g);
        return;
    }
    for (int i = 0; i < 3; i++)
        end[i] = base[i] == 0 ? random_zero(g) : base[i];
}

/* d and the normals: not finite, or zero. */
void spoil_direction(double v[3], const double unused[3], rng *g)
{
    static const double zero[3];
    (void)unused;
    spoil_end(v, zero, g);
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
static void spoil_t_max(double *t_min, double *t_max, rng *g)
{
    switch (rng_integer(g, 0, 3)) {
    case 0: *t_max = NAN; break;
    case 1: *t_max = -HUGE_VAL; break;
    case 2: *t_max = step_ulps(*t_min, -1); break;
    default:
        *t_min = rng_magnitude(g, -10, 10);
        *t_max = *t_min / 2;
        break;
    }
}

enum { RAY_FIELDS = 4 }; /* o, d, t_min, t_max; then those of the object */

static int field_count(sure_shape shape)
{
    return RAY_FIELDS + sure_shape_info_of(shape)->field_count;
}

static void spoil_object(sure_shape shape, double *object, int field, rng *g)
{
    const sure_shape_field *which = &sure_shape_info_of(shape)->fields[field];
    if (field == 0)
        spoil_vector(object, g);
    else if (which->kind == SURE_KIND_RADIUS)
        spoil_size(object + which->at, g);
    else
        case_shape_of(shape)->spoil(object + which->at, object, g);
}

static void spoil_field(sure_shape shape, double *number, int field, rng *g)
{
    switch (field) {
    case 0: spoil_vector(number + AT_O, g); break;
    case 1: spoil_direction(number + AT_D, NULL, g); break;
    case 2: spoil_size(number + AT_T_MIN, g); break;
    case 3: spoil_t_max(number + AT_T_MIN, number + AT_T_MAX, g); break;
    default: spoil_object(shape, number + AT_OBJECT, field - RAY_FIELDS, g);
    }
}

/* One field wrong; in a third of draws up to three. */
static numbered invalid_case(sure_shape shape, rng *g)
{
    numbered c = rng_chance(g, 1, 2) ? make_typical(shape, g) : make_tangent(shape, g);
    int spoilt = rng_chance(g, 1, 3) ? rng_integer(g, 2, 3) : 1;
    for (int i = 0; i < spoilt; i++) {
        int field = rng_integer(g, 0, field_count(shape) - 1);
        spoil_field(shape, c.number, field, g);
    }
    return c;
}

/* A ray through, along or past what is left of the object without its radius: its axis or its
 * centre. */
static layout shrunken_layout(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape};
    if (has_height(shape)) {
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

/* 0, -0 or, so far below the rest that its square is 0, the least radii. */
static double random_vanishing_radius(rng *g)
{
    if (rng_chance(g, 1, 2))
        return random_zero(g);
    return ldexp(rng_whole(g, 40), -1074);
}

static numbered shrunken_case(sure_shape shape, rng *g)
{
    layout lay = shrunken_layout(shape, g);
    range_at_t(&lay, g);
    numbered c = place_exactly(&lay, g);
    nudge_one_in(8, &c, g);
    int count = case_numbers(shape);
    if (field_at(shape, count - 1)->kind == SURE_KIND_RADIUS)
        c.number[count - 1] = random_vanishing_radius(g);
    for (int i = 0; i < count; i++)
        if (c.number[i] == 0 && rng_chance(g, 1, 2))
            c.number[i] = -c.number[i];
    return c;
}

numbered make_degenerate(sure_shape shape, rng *g)
{
    return rng_chance(g, 1, 3) ? invalid_case(shape, g) : shrunken_case(shape, g);
}

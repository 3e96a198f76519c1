/* degenerate: valid inputs that have lost a dimension or a sign, and every kind of invalid one. */
#include "regimes_makers.h"

#include <math.h>

/* What can be wrong with one number, or with three at once. */
static double draw_bad(draws *d)
{
    switch (draw_integer(d, 0, 2)) {
    case 0: return NAN;
    case 1: return HUGE_VAL;
    default: return -HUGE_VAL;
    }
}

static double draw_zero(draws *d)
{
    return draw_sign(d) * 0.0;
}

static void spoil_vector(double v[3], draws *d)
{
    int i = draw_integer(d, 0, 2);
    v[i] = draw_bad(d);
}

/* d and the normals: not finite, or zero. */
void spoil_direction(double v[3], const double unused[3], draws *d)
{
    (void)unused;
    if (draw_chance(d, 1, 2)) {
        spoil_vector(v, d);
        return;
    }
    for (int i = 0; i < 3; i++)
        v[i] = draw_zero(d);
}

/* top and apex: not finite, or the base, in which 0 and -0 are the same. */
void spoil_end(double end[3], const double base[3], draws *d)
{
    if (draw_chance(d, 1, 2)) {
        spoil_vector(end, d);
        return;
    }
    for (int i = 0; i < 3; i++)
        end[i] = base[i] == 0 ? draw_zero(d) : base[i];
}

/* t_min and radius: not finite, or negative, if by the least. */
static void spoil_size(double *size, draws *d)
{
    if (draw_chance(d, 1, 2))
        *size = draw_bad(d);
    else
        *size = draw_chance(d, 1, 2) ? -0x1p-1074 : -draw_magnitude(d, -10, 10);
}

/* t_max: not a number, or below t_min, if by the least. */
static void spoil_t_max(double *t_min, double *t_max, draws *d)
{
    switch (draw_integer(d, 0, 3)) {
    case 0: *t_max = NAN; break;
    case 1: *t_max = -HUGE_VAL; break;
    case 2: *t_max = step_ulps(*t_min, -1); break;
    default:
        *t_min = draw_magnitude(d, -10, 10);
        *t_max = *t_min / 2;
        break;
    }
}

enum { RAY_FIELDS = 4 }; /* o, d, t_min, t_max; then those of the object */

static int field_count(sure_shape shape)
{
    return RAY_FIELDS + sure_shape_info_of(shape)->field_count;
}

static void spoil_object(sure_shape shape, double *object, int field, draws *d)
{
    const sure_shape_field *which = &sure_shape_info_of(shape)->fields[field];
    if (field == 0)
        spoil_vector(object, d);
    else if (which->kind == SURE_KIND_RADIUS)
        spoil_size(object + which->at, d);
    else
        case_shape_of(shape)->spoil(object + which->at, object, d);
}

static void spoil_field(sure_shape shape, double *number, int field, draws *d)
{
    switch (field) {
    case 0: spoil_vector(number + AT_O, d); break;
    case 1: spoil_direction(number + AT_D, NULL, d); break;
    case 2: spoil_size(number + AT_T_MIN, d); break;
    case 3: spoil_t_max(number + AT_T_MIN, number + AT_T_MAX, d); break;
    default: spoil_object(shape, number + AT_OBJECT, field - RAY_FIELDS, d);
    }
}

/* One field wrong; in a third of draws up to three. */
static sure_case invalid_case(sure_shape shape, draws *d)
{
    sure_case c = draw_chance(d, 1, 2) ? make_typical(shape, d) : make_tangent(shape, d);
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(&c, number);
    int spoilt = draw_chance(d, 1, 3) ? draw_integer(d, 2, 3) : 1;
    for (int i = 0; i < spoilt; i++) {
        int field = draw_integer(d, 0, field_count(shape) - 1);
        spoil_field(shape, number, field, d);
    }
    return case_from_numbers(shape, number);
}

/* A ray through, along or past what is left of the object without its radius: its axis or its
 * centre. */
static layout shrunken_layout(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape};
    if (has_height(shape)) {
        lay.h = draw_whole_size(d);
        lay.p.z = floor(draw_between(d, -lay.h / 8, lay.h * 9 / 8));
    }
    lay.d = draw_whole_vector(d, WAY_BITS);
    if (!case_shape_has(shape, CASE_HAS_INSIDE) && draw_chance(d, 1, 4) &&
        (lay.d.x != 0 || lay.d.y != 0))
        lay.d.z = 0;
    if (draw_chance(d, 1, 8))
        lay.d = (sure_vec3){0, 0, draw_signed(d, WAY_BITS)};
    if (draw_chance(d, 1, 8))
        lay.p.x = draw_signed(d, SIZE_BITS);
    lay.t = draw_whole(d, TIME_BITS);
    if (draw_chance(d, 1, case_shape_has(shape, CASE_HAS_NO_END) ? 4 : 8))
        lay.t = -lay.t;
    return lay;
}

/* 0, -0 or, so far below the rest that its square is 0, the least radii. */
static double draw_vanishing_radius(draws *d)
{
    if (draw_chance(d, 1, 2))
        return draw_zero(d);
    return ldexp(draw_whole(d, 40), -1074);
}

static sure_case shrunken_case(sure_shape shape, draws *d)
{
    layout lay = shrunken_layout(shape, d);
    range_at_t(&lay, d);
    pose where = pose_exact(shape, d);
    sure_case c = place(&lay, &where);
    if (draw_chance(d, 1, 8))
        nudge(&c, d);
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(&c, number);
    int count = case_numbers(shape);
    if (field_at(shape, count - 1)->kind == SURE_KIND_RADIUS)
        number[count - 1] = draw_vanishing_radius(d);
    for (int i = 0; i < count; i++)
        if (number[i] == 0 && draw_chance(d, 1, 2))
            number[i] = -number[i];
    return case_from_numbers(shape, number);
}

sure_case make_degenerate(sure_shape shape, draws *d)
{
    return draw_chance(d, 1, 3) ? invalid_case(shape, d) : shrunken_case(shape, d);
}

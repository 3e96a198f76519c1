/* bits: numbers of every exponent class, made of structured bit patterns. */
#include "regimes_makers.h"

#include <float.h>
#include <math.h>

/* The doubles next to which the format changes. */
static double draw_landmark(draws *d)
{
    static const double landmark[] = {
        0,        0x1p-1074, DBL_MIN,
        DBL_MAX,  0x1p1023,  0x1p-1022 - 0x1p-1074, /* the largest subnormal */
        0x1p-537,                                   /* its square is the least subnormal */
        0x1p512,                                    /* the least whose square overflows */
        1,        0x1p52,    0x1p53,                /* from here on all are even */
    };
    int last = (int)(sizeof landmark / sizeof landmark[0]) - 1;
    double x = landmark[draw_integer(d, 0, last)];
    int steps = draw_integer(d, -1, 1);
    return x == DBL_MAX || (x == 0 && steps < 0) ? x : step_ulps(x, steps);
}

static double draw_mantissa(draws *d)
{
    switch (draw_integer(d, 0, 5)) {
    case 0: return 1;
    case 1: return 1 + DBL_EPSILON;
    case 2: return 2 - DBL_EPSILON;
    case 3: /* 1.010101... */ return 1 + 0x5555555555555p-52;
    case 4: /* a few leading digits */ return 1 + draw_integer(d, 0, 15) * 0x1p-4;
    default: return draw_magnitude(d, 0, 1);
    }
}

/* A number near 2^about, at a landmark, of any exponent, or zero. */
static double draw_pattern(draws *d, int about)
{
    double sign = draw_sign(d);
    int kind = draw_integer(d, 0, 9);
    if (kind == 0)
        return sign * 0.0;
    if (kind == 1)
        return sign * draw_landmark(d);
    int exponent = kind == 2 ? draw_integer(d, -1074, 1023) : about + draw_integer(d, -2, 2);
    exponent = exponent > 1023 ? 1023 : exponent;
    return sign * ldexp(draw_mantissa(d), exponent);
}

/* Subnormal, normal or near overflow with equal weight, not by their number of exponents. */
static int draw_about(draws *d)
{
    switch (draw_integer(d, 0, 4)) {
    case 0: return draw_integer(d, -1074, -1022);
    case 1: return draw_integer(d, 1000, 1023);
    case 2: return draw_integer(d, -1022, 1023);
    default: return draw_integer(d, -4, 4);
    }
}

static void draw_range(double *t_min, double *t_max, draws *d, int about)
{
    *t_min = 0;
    *t_max = HUGE_VAL;
    if (draw_chance(d, 3, 4))
        return;
    *t_min = fabs(draw_pattern(d, about));
    double end = fabs(draw_pattern(d, about));
    if (end >= *t_min)
        *t_max = end;
}

/* The direction from the start to the object's own point, halved so that it does not overflow. */
static void aim_at_object(double *number)
{
    for (int i = 0; i < 3; i++)
        number[AT_D + i] = number[AT_OBJECT + i] / 2 - number[AT_O + i] / 2;
}

sure_case make_bits(sure_shape shape, draws *d)
{
    double number[CASE_NUMBERS_MAX];
    int count = case_numbers(shape);
    int about = draw_about(d);
    int d_about = draw_chance(d, 1, 2) ? about : draw_about(d);
    for (int i = 0; i < count; i++)
        number[i] = draw_pattern(d, i >= AT_D && i < AT_T_MIN ? d_about : about);
    case_shape_of(shape)->mend(shape, number + AT_OBJECT);
    int t_about = draw_about(d);
    draw_range(&number[AT_T_MIN], &number[AT_T_MAX], d, t_about);
    if (draw_chance(d, 2, 3))
        aim_at_object(number);
    if (draw_chance(d, 1, 20)) {
        int spoilt = draw_integer(d, 0, count - 1);
        number[spoilt] = draw_chance(d, 1, 2) ? (double)NAN : draw_sign(d) * HUGE_VAL;
    }
    return case_from_numbers(shape, number);
}

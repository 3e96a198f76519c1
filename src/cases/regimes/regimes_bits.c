/* SPDX-License-Identifier: MIT */
/* bits: numbers of every exponent class, made of structured bit patterns. */
#include "regimes_layout.h"

#include <float.h>
#include <math.h>

/* The doubles next to which the format changes. */
static double random_landmark(rng *g)
{
    static const double landmark[] = {
        0,        0x1p-1074, DBL_MIN,
        DBL_MAX,  0x1p1023,  0x1p-1022 - 0x1p-1074, /* the largest subnormal */
        0x1p-537,                                   /* its square is the least subnormal */
        0x1p512,                                    /* the least whose square overflows */
        1,        0x1p52,    0x1p53,                /* from here on all are even */
    };
    int last = (int)(sizeof landmark / sizeof landmark[0]) - 1;
    double x = landmark[rng_integer(g, 0, last)];
    int steps = rng_integer(g, -1, 1);
    return x == DBL_MAX || (x == 0 && steps < 0) ? x : step_ulps(x, steps);
}

static double random_mantissa(rng *g)
{
    switch (rng_integer(g, 0, 5)) {
    case 0: return 1;
    case 1: return 1 + DBL_EPSILON;
    case 2: return 2 - DBL_EPSILON;
    case 3: /* 1.010101... */ return 1 + 0x5555555555555p-52;
    case 4: /* a few leading digits */ return 1 + rng_integer(g, 0, 15) * 0x1p-4;
    default: return rng_magnitude(g, 0, 1);
    }
}

/* A number near 2^about, at a landmark, of any exponent, or zero. */
static double random_pattern(rng *g, int about)
{
    double sign = rng_sign(g);
    int kind = rng_integer(g, 0, 9);
    if (kind == 0)
        return sign * 0.0;
    if (kind == 1)
        return sign * random_landmark(g);
    int exponent = kind == 2 ? rng_integer(g, -1074, 1023) : about + rng_integer(g, -2, 2);
    exponent = exponent > 1023 ? 1023 : exponent;
    return sign * ldexp(random_mantissa(g), exponent);
}

/* Subnormal, normal or near overflow with equal weight, not by their number of exponents. */
static int random_about(rng *g)
{
    switch (rng_integer(g, 0, 4)) {
    case 0: return rng_integer(g, -1074, -1022);
    case 1: return rng_integer(g, 1000, 1023);
    case 2: return rng_integer(g, -1022, 1023);
    default: return rng_integer(g, -4, 4);
    }
}

static void random_range(sure_ray *ray, rng *g, int about)
{
    ray->t_min = 0;
    ray->t_max = HUGE_VAL;
    if (rng_chance(g, 3, 4))
        return;
    ray->t_min = fabs(random_pattern(g, about));
    double end = fabs(random_pattern(g, about));
    if (end >= ray->t_min)
        ray->t_max = end;
}

sure_case make_bits(sure_shape shape, rng *g)
{
    sure_case c = {.object.shape = shape};
    int count = case_numbers(shape);
    int about = random_about(g);
    int d_about = rng_chance(g, 1, 2) ? about : random_about(g);
    for (int i = 0; i < count; i++)
        *case_number(&c, i) = random_pattern(g, i >= AT_D && i < AT_T_MIN ? d_about : about);
    object_mend(shape, case_number(&c, AT_OBJECT));
    int t_about = random_about(g);
    random_range(&c.ray, g, t_about);
    bool aimed = rng_chance(g, 2, 3); /* at the object's own point; halved, it does not overflow */
    for (int i = 0; i < 3 && aimed; i++)
        *case_number(&c, AT_D + i) = *case_number(&c, AT_OBJECT + i) / 2 - *case_number(&c, i) / 2;
    if (rng_chance(g, 1, 20)) {
        int spoilt = rng_integer(g, 0, count - 1);
        *case_number(&c, spoilt) = rng_chance(g, 1, 2) ? (double)NAN : rng_sign(g) * HUGE_VAL;
    }
    return c;
}

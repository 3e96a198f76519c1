#include "planar_suite.h"

enum { DRAWN = 3000, AT_PLACE = AT_OBJECT, AT_NORMAL = AT_OBJECT + 3 };

void planar_crossing(const true_line *line, mpfr_t t, mpfr_t outside)
{
    mpfr_neg(t, line->level, MPFR_RNDN);
    mpfr_div(t, t, line->slope, MPFR_RNDN);
    mpfr_mul(outside, line->a, t, MPFR_RNDN);
    mpfr_add(outside, outside, line->b, MPFR_RNDN);
    mpfr_add(outside, outside, line->b, MPFR_RNDN);
    mpfr_fma(outside, outside, t, line->c, MPFR_RNDN);
}

static sure_case drawn(sure_shape shape, uint64_t i)
{
    double numbers[CASE_NUMBERS_MAX];
    int reach = (int)(suite_bits(41, i) % 50), slope = (int)(suite_bits(42, i) % 50);
    double beside = power_of_two(-(int)(suite_bits(60, i) % 30));
    bool within = suite_bits(43, i) % 4 == 0;
    for (int k = 0; k < CASE_NUMBERS_MAX; k++)
        numbers[k] = suite_double(44 + (uint64_t)k, i, 0);
    for (int k = 0; k < 3; k++) {
        numbers[k] = numbers[AT_PLACE + k] - numbers[3 + k] * power_of_two(reach);
        numbers[k] += k < 2 ? suite_double(62 + (uint64_t)k, i, 0) * beside : 0;
    }
    if (within || suite_bits(61, i) % 2 == 0) {
        numbers[AT_NORMAL] = numbers[AT_NORMAL + 1] = 0;
        numbers[AT_PLACE + 2] = numbers[2] = 0;
        numbers[5] = within ? 0 : numbers[5] * power_of_two(-slope);
        numbers[2] = within ? 0 : -numbers[5] * power_of_two(reach);
    }
    numbers[AT_T_MIN] = 0;
    numbers[AT_T_MIN + 1] = INFINITY;
    return case_from_numbers(shape, numbers);
}

/* The point next to the place: its t, and |p|^2 - r^2. */
static void foot(const true_line *line, mpfr_t t, mpfr_t outside)
{
    mpfr_div(t, line->b, line->a, MPFR_RNDN);
    mpfr_mul(outside, t, line->b, MPFR_RNDN);
    mpfr_neg(t, t, MPFR_RNDN);
    mpfr_sub(outside, line->c, outside, MPFR_RNDN);
}

sure_case planar_near(sure_shape shape, uint64_t i, true_line *line)
{
    sure_case c = drawn(shape, i);
    mpfr_t t, outside;
    mpfr_inits2(PLANAR_BITS, t, outside, (mpfr_ptr)NULL);
    true_line_set(line, &c);
    (mpfr_zero_p(line->slope) ? foot : planar_crossing)(line, t, outside);
    double near = mpfr_get_d(t, MPFR_RNDN), ulps = (double)suite_integer(64, i, 4) * 0x1p-53;
    if (suite_bits(65, i) % 2 == 0 && near > 0)
        c.ray.t_min = near + near * ulps * power_of_two((int)(suite_bits(66, i) % 8));
    if (line->round) {
        mpfr_set_d(t, c.object.as.disc.radius, MPFR_RNDN);
        mpfr_fma(outside, t, t, outside, MPFR_RNDN);
        mpfr_sqrt(outside, outside, MPFR_RNDN);
        double r = mpfr_get_d(outside, MPFR_RNDN);
        c.object.as.disc.radius = r + r * (double)suite_integer(67, i, 4) * 0x1p-53;
    }
    mpfr_clears(t, outside, (mpfr_ptr)NULL);
    return c;
}

void planar_each_near(sure_shape shape, case_compute *what, case_compute *judge, void *context)
{
    true_line line;
    true_line_init(&line, PLANAR_BITS);
    for (uint64_t i = 0; i < DRAWN; i++) {
        sure_case c = planar_near(shape, i, &line);
        if (case_is_valid(&c))
            in_each_environment(&c, what, judge, context);
    }
    true_line_clear(&line);
}

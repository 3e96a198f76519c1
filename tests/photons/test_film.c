/* SPDX-License-Identifier: MIT */
/* The film: exact sums, in whatever order, against whole numbers of any size; pictures, means and
 * variances by hand. */
#include "../../src/photons/film.h"
#include "../support/suite.h"

#include <gmp.h>

#define ADDED 200

static film made(int width, int height)
{
    film of;
    ck_assert(film_new(width, height, &of));
    return of;
}

/* Numbers of every size, of which some are nothing, some ties between two steps, some too large. */
static double drawn(uint64_t stream, uint64_t index)
{
    static const double odd[] = {0,       -0.0,          NAN,           -1,      INFINITY,
                                 DBL_MAX, -INFINITY,     DBL_TRUE_MIN,  0x1p-33, 0x1.8p-32,
                                 0x1p96,  0x1p-33 * 0.9, 0x1p95,        0x1p21,  0x1.8p20,
                                 0x1p31,  0x1p32,        0x1.fffffp31,  0x1p63,  0x1p64,
                                 0x1p-16, 0x1.8p-17,     0x1.6a09e6p-17};
    const uint64_t count = sizeof odd / sizeof *odd;
    uint64_t kind = suite_bits(stream + 1, index) % 8;
    if (kind == 0)
        return odd[suite_bits(stream + 2, index) % count];
    if (kind == 1)
        return ((double)(suite_bits(stream + 3, index) % 4096) + 0.5) * 0x1p-32;
    return fabs(suite_double(stream, index, kind == 2 ? 60 : 30));
}

/* The same number of steps by GMP: the nearest, a half up, and at most 2^128 - 1. */
static void add_exactly(mpz_t sum, double value)
{
    if (!(value > 0))
        return;
    if (value > 0x1p100)
        value = 0x1p100;
    int exponent;
    double mantissa = frexp(value, &exponent);
    mpz_t steps;
    mpz_init_set_d(steps, ldexp(mantissa, 53)); /* value = steps 2^(exponent - 53) */
    exponent += 32 - 53;
    mpz_mul_2exp(steps, steps, exponent > 0 ? (unsigned)exponent + 1 : 1);
    if (exponent < 0)
        mpz_fdiv_q_2exp(steps, steps, (unsigned)-exponent);
    mpz_add_ui(steps, steps, 1);
    mpz_fdiv_q_2exp(steps, steps, 1);
    mpz_add(sum, sum, steps);
    mpz_ui_pow_ui(steps, 2, 128);
    mpz_sub_ui(steps, steps, 1);
    if (mpz_cmp(sum, steps) > 0)
        mpz_set(sum, steps);
    mpz_clear(steps);
}

static void assert_sum(film_sum sum, const mpz_t expected, uint64_t stream)
{
    mpz_t limbs;
    mpz_init_set_ui(limbs, (uint64_t)(sum >> 64));
    mpz_mul_2exp(limbs, limbs, 64);
    mpz_add_ui(limbs, limbs, (uint64_t)sum);
    ck_assert_msg(mpz_cmp(limbs, expected) == 0, "stream %llu", (unsigned long long)stream);
    mpz_clear(limbs);
}

static void assert_sums(const film *of, const mpz_t value, const mpz_t square, uint64_t stream)
{
    assert_sum(of->pixels->value[0], value, stream);
    assert_sum(of->pixels->value[2], value, stream);
    assert_sum(of->pixels->square[0], square, stream);
}

/* One added at a time; and each to one of several films, which are then added up. What is exact
 * depends on no order. */
static void expect_sums(const double *values, int count, uint64_t stream)
{
    FREED_BY(film_free) film of = made(1, 1), first = made(1, 1), second = made(1, 1);
    mpz_t value, square;
    mpz_inits(value, square, NULL);
    for (int i = 0; i < count; i++) {
        double v = values[i];
        film_add(&of, 0, 0, (sure_vec3){v, 0, v});
        add_exactly(value, v);
        add_exactly(square, v > 0 ? v * v : 0);
        film_add(i % 2 ? &first : &second, 0, 0, (sure_vec3){v, 0, v});
        assert_sums(&of, value, square, stream);
    }
    film_merge(&second, &first);
    assert_sums(&second, value, square, stream);
    mpz_clears(value, square, NULL);
}

TEST(sums_are_exact)
{
    double values[ADDED];
    for (uint64_t stream = 0; stream < 400; stream += 4) {
        for (uint64_t i = 0; i < ADDED; i++)
            values[i] = drawn(stream, i);
        expect_sums(values, ADDED, stream);
    }
}

/* Carries from limb to limb that chance does not meet. */
TEST(carries)
{
    static const double cases[][3] = {{0x1p31, 0x1p31, 0},
                                      {0x1p32, 0x1p-32, 0},
                                      {0x1p95, 0x1p94, 0x1p93},
                                      {0x1p95, 0x1p95, 0x1p-32},
                                      {0x1p96, 0x1p-32, 1},
                                      {INFINITY, 0, 0},
                                      {0x1.fffffffffffffp95, 0x1p42, 0x1p42},
                                      {0x1.fffffffffffffp95, 0x1p43, 0},
                                      {0x1p-33, 0x1p-33, 0},
                                      {0x1.fffffffffffffp-34, 0, 0},
                                      {0x1.8p-32, 0, 0},
                                      {-1, NAN, -INFINITY},
                                      {0, -0.0, DBL_TRUE_MIN}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect_sums(cases[i], 3, i);
    /* Full but for the last step, and then full: the carry of the low limb fills the high one. */
    FREED_BY(film_free) film of = made(1, 1), more = made(1, 1);
    of.pixels->value[0] = -(film_sum)2;
    more.pixels->value[0] = 1;
    for (int i = 0; i < 2; i++) {
        film_merge(&of, &more);
        ck_assert(of.pixels->value[0] == -(film_sum)1);
    }
}

TEST(rows_are_counted_from_below)
{
    FREED_BY(film_free) film of = made(2, 3);
    film_add(&of, 1, 0, (sure_vec3){1, 2, 3});
    for (int i = 0; i < 6; i++) {
        const film_pixel *pixel = &of.pixels[i];
        for (int j = 0; j < 3; j++) {
            film_sum value = i == 5 ? (film_sum)(j + 1) : 0;
            ck_assert(pixel->value[j] == value << 32);
            ck_assert(pixel->square[j] == value * value << 32);
        }
    }
}

/* Four photons: the mean of a pixel, its level, and levels where they change. */
TEST(pictures)
{
    FREED_BY(film_free) film of = made(2, 2);
    FREED_BY(picture_free) picture image, bright, none;
    film_add(&of, 0, 1, (sure_vec3){4, 2, 1});
    film_add(&of, 1, 1, (sure_vec3){4 * 0.51 / 255, 4 * 0.49 / 255, 400});
    film_add(&of, 0, 0, (sure_vec3){2, 0, 0});
    film_add(&of, 0, 0, (sure_vec3){1, 0, 0});
    ck_assert(film_picture_new(&of, 4, &image));
    ck_assert_mem_eq(image.rgb, ((uint8_t[]){255, 128, 64, 1, 0, 255, 191, 0, 0, 0, 0, 0}), 12);
    film_add(&of, 1, 0, (sure_vec3){0x1p50, 0x1p48, 0x1.8p50});
    ck_assert(film_picture_new(&of, UINT64_C(1) << 51, &bright));
    ck_assert_mem_eq(bright.rgb + 9, ((uint8_t[]){128, 32, 191}), 3);
    /* Without photons nothing is dark but what has no light at all. */
    ck_assert(film_picture_new(&of, 0, &none));
    ck_assert(none.rgb[0] == 255 && none.rgb[7] == 0);
}

TEST(means_and_variances)
{
    FREED_BY(film_free) film of = made(2, 1);
    ck_double_same(film_mean(&of, 5), 0);
    ck_double_same(film_variance(&of, 5), 0);
    film_add(&of, 0, 0, (sure_vec3){3, 0, 0});
    film_add(&of, 0, 0, (sure_vec3){1, 0, 0});
    film_add(&of, 1, 0, (sure_vec3){0, 0, 2});
    /* Of four photons one pixel's red had 3, 1, 0, 0: mean 1, variance 6/3, of the mean 6/12; the
     * other's blue had 2, 0, 0, 0: mean 1/2, squares 3, of the mean 3/12. Six sums. */
    ck_double_same(film_mean(&of, 4), 6 / 4.0 / 6);
    ck_double_same(film_variance(&of, 4), (6 / 12.0 + 3 / 12.0) / 6);
    ck_assert(isinf(film_variance(&of, 1)));
    ck_assert(isinf(film_variance(&of, 0)));
}

/* Every photon gives the same: no variance, and never a negative one. */
TEST(no_variance)
{
    for (uint64_t i = 0; i < 1000; i++) {
        FREED_BY(film_free) film of = made(1, 1);
        double v = fabs(suite_double(7000, i, 3));
        for (int j = 0; j < 7; j++)
            film_add(&of, 0, 0, (sure_vec3){v, v, v});
        double variance = film_variance(&of, 7);
        /* Square and value are off by half a step each, the rest by less than 8 roundings. */
        double steps = 0x1p-33 * (1 + 2 * v) + 0x1p-66;
        ck_assert_msg(variance >= 0 && variance <= (steps + 8 * DBL_EPSILON * v * v) / 6, "%a", v);
    }
}

TEST(sizes)
{
    film of;
    ck_assert(!film_new(0, 1, &of));
    ck_assert(!film_new(1, 0, &of));
    ck_assert(!film_new(-1, 1, &of));
    ck_assert(!film_new(INT32_MAX, INT32_MAX, &of));
}

SUITE("film")

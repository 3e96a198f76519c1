/* SPDX-License-Identifier: MIT */
/* What every test program shares: how it runs, how it fails, where the tests' files lie; and the
 * headers that nearly all of them ask for. */
#pragma once

#include <check.h>

/* Check would write the place of each assertion that holds to a file, for the case of a crash: of
 * a test's time up to half. */
#define _mark_point(file, line) ((void)0)

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <surehit/surehit.h>

/* A test, or one for each _i from 0 to count - 1. It is named nowhere else: SUITE runs those of its
 * file in their order. CK_RUN_CASE=NAME in the environment runs the test NAME alone (Check's own
 * variable). */
#define TEST(name) LOOP_TEST(name, 1)
#define LOOP_TEST(name, count) TEST_OF(name, count, .signal = 0)
/* For each shape, _i, and named by it: CK_RUN_CASE takes a shape. */
#define SHAPE_TEST(name) TEST_OF(name, SURE_SHAPES, .of_shapes = true)
/* What it does ends in a signal. */
#define SIGNAL_TEST(name, number) TEST_OF(name, 1, .signal = number)

#define TEST_OF(name, times, ...)                                                                  \
    static void name##_run(int _i);                                                                \
    static const TTest name##_test = {#name, name##_run, __FILE__, __LINE__};                      \
    __attribute__((constructor)) static void name##_add(void)                                      \
    {                                                                                              \
        suite_add((suite_test){&name##_test, times, __VA_ARGS__});                                 \
    }                                                                                              \
    static void name##_run(int _i CK_ATTRIBUTE_UNUSED)

/* main, which is 0 when every check passed, 1 otherwise; ... */
#define SUITE(title) SUITE_IN(title, NULL, NULL)
/* ... each test between these two. */
#define SUITE_IN(title, set_up, tear_down)                                                         \
    int main(void)                                                                                 \
    {                                                                                              \
        return suite_main(title, set_up, tear_down);                                               \
    }

typedef struct {
    const TTest *test;
    int count, signal;
    bool of_shapes;
} suite_test;

void suite_add(suite_test test);
int suite_main(const char *title, SFun set_up, SFun tear_down);

/* What a shape's parts have: float32 and textbook. Every other stem has stable, too, and the shapes
 * have all SURE_TIERS. */
enum { PART_TIERS = SURE_TIER_TEXTBOOK + 1, PLAIN_TIERS = SURE_TIER_STABLE + 1 };

/* A function of the plain tiers, by tier; and x as the tier's arithmetic has it. */
#define OF_PLAIN_TIERS(name)                                                                       \
    {                                                                                              \
        name##_float32, name##_textbook, name##_stable                                             \
    }
double suite_rounded(int tier, double x);

/* A number from the environment, at least 1, or that otherwise. SUREHIT_SHARE: every how many cases
 * of a world or regime are asked. */
uint64_t suite_setting(const char *name, uint64_t otherwise);

/* Before a variable: at the end of its block that function is called with its address. free_text:
 * of a char *. */
#define FREED_BY(function) __attribute__((cleanup(function)))
void free_text(char **text);

/* The path of a file in the tests' folder, named as by printf; valid until the next call. */
const char *suite_file(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Fails unless both doubles, or vectors, are equal; the message shows hex floats. */
#define ck_double_same(...) suite_double_same(__FILE__, __LINE__, __VA_ARGS__)
#define ck_vector_same(...) suite_vector_same(__FILE__, __LINE__, __VA_ARGS__)
void suite_double_same(const char *file, int line, double value, double expected);
void suite_vector_same(const char *file, int line, sure_vec3 value, sure_vec3 expected);

/* Draw `index` of a stream: 64 random bits, an integer in [-limit, limit], or a double in [-1, 1)
 * times a power of two in 2^-spread..2^spread. */
uint64_t suite_bits(uint64_t stream, uint64_t index);
int suite_integer(uint64_t stream, uint64_t index, int limit);
double suite_double(uint64_t stream, uint64_t index, int spread);

/* The same three times, from streams that follow one another. */
sure_vec3 suite_integers(uint64_t stream, uint64_t index, int limit);
sure_vec3 suite_doubles(uint64_t stream, uint64_t index, int spread);

/* suite_double rounded to single precision. (GCC 12 at -O2 drops the rounding of neighbouring
 * (double)(float)x when it vectorises them; a call keeps it.) */
float suite_single(uint64_t stream, uint64_t index, int spread);

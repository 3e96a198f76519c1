/* SPDX-License-Identifier: MIT */
/* integers: every case whose numbers are very small integers, once each, in an order that makes any
 * first part a good sample. */
#include "../regimes.h"
#include "../shapes/case_shape.h"

#include <math.h>
#include <string.h>

/* Random123 refuses machines that it was not tried on. Threefry adds, rotates and xors words of 64
 * bits, and nothing else: it passes as one of those. */
#ifdef __wasm__
#define __riscv
#include <Random123/threefry.h>
#undef __riscv
#else
#include <Random123/threefry.h>
#endif

/* A code in mixed radix: its lowest digit is taken off. */
static int take(uint64_t *code, int radix)
{
    int digit = (int)(*code % (uint64_t)radix);
    *code /= (uint64_t)radix;
    return digit;
}

/* One of the vectors of -1, 0, 1. */
static sure_vec3 near_vector(int code)
{
    return (sure_vec3){code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
}

/* One of the 98 vectors of -2 .. 2 that are not among these: the faces z = -2, 2; what is left of
 * the faces y = -2, 2; and of x = -2, 2. */
#define FAR_VECTORS 98

static sure_vec3 far_vector(int code)
{
    if (code < 50)
        return (sure_vec3){code % 5 - 2, code / 5 % 5 - 2, code / 25 * 4 - 2};
    code -= 50;
    if (code < 30)
        return (sure_vec3){code % 5 - 2, code / 15 * 4 - 2, code / 5 % 3 - 1};
    code -= 30;
    return (sure_vec3){code / 9 * 4 - 2, code % 3 - 1, code / 3 % 3 - 1};
}

/* The world: points and normals in -1 .. 1; rays from a start in -2 .. 2 to any other place in -1
 * .. 1, which they reach at t = 1. */
#define NEAR_RAYS (SMALL_VECTORS * (SMALL_VECTORS - 1))
#define RAYS (NEAR_RAYS + FAR_VECTORS * SMALL_VECTORS)
#define RANGES 4

static const double range[RANGES][2] = {{0, HUGE_VAL}, {0, 1}, {1, HUGE_VAL}, {0, 2}};

uint64_t regime_integers_count(sure_shape shape)
{
    return (uint64_t)RAYS * RANGES * (uint64_t)case_shape_of(shape)->small_objects;
}

static sure_ray take_ray(uint64_t *code)
{
    const double *t = range[take(code, RANGES)];
    int pair = take(code, RAYS);
    int start, end;
    sure_ray ray = {.t_min = t[0], .t_max = t[1]};
    if (pair < NEAR_RAYS) {
        start = pair / (SMALL_VECTORS - 1);
        end = pair % (SMALL_VECTORS - 1);
        end += end >= start;
        ray.origin = near_vector(start);
    } else {
        start = (pair - NEAR_RAYS) / SMALL_VECTORS;
        end = (pair - NEAR_RAYS) % SMALL_VECTORS;
        ray.origin = far_vector(start);
    }
    ray.direction = difference_of(near_vector(end), ray.origin);
    return ray;
}

/* The radius, the first vector, the second. */
void small_fields(sure_case *c, uint64_t code)
{
    const sure_shape_info *info = sure_shape_info_of(c->object.shape);
    bool two = info->fields[1].kind != SURE_KIND_RADIUS;
    int vectors = SMALL_VECTORS * (two ? SMALL_VECTORS - 1 : 1);
    double radius = take(&code, case_shape_of(c->object.shape)->small_objects / vectors);
    int first = take(&code, SMALL_VECTORS);
    int other = info->fields[1].kind == SURE_KIND_NORMAL ? SMALL_ZERO : first;
    sure_vec3 vector[2] = {near_vector(first)};
    int second = two ? take(&code, SMALL_VECTORS - 1) : 0; /* of those that are not the other */
    if (two)
        vector[1] = near_vector(second >= other ? second + 1 : second);
    memcpy(case_number(c, AT_OBJECT), vector, sizeof vector);
    if (info->fields[info->field_count - 1].kind == SURE_KIND_RADIUS)
        *case_number(c, AT_OBJECT + info->numbers - 1) = radius;
}

/* A permutation of 0 .. 4^half_bits - 1 that depends on the seed: four rounds of a Feistel
 * network. */
static uint64_t shuffle(uint64_t x, int half_bits, const rng *g)
{
    uint64_t mask = ((uint64_t)1 << half_bits) - 1;
    uint64_t left = x >> half_bits, right = x & mask;
    threefry2x64_key_t key = {{g->key[0], g->key[1]}};
    for (uint64_t round = 0; round < 4; round++) {
        threefry2x64_ctr_t counter = {{right, round}};
        uint64_t next = left ^ (threefry2x64(counter, key).v[0] & mask);
        left = right;
        right = next;
    }
    return left << half_bits | right;
}

/* Shuffled until it falls among the first `count`, which are more than a quarter of all: a
 * permutation of these. */
static uint64_t shuffle_below(uint64_t x, uint64_t count, const rng *g)
{
    int half_bits = 1;
    while ((uint64_t)1 << 2 * half_bits < count)
        half_bits++;
    do
        x = shuffle(x, half_bits, g);
    while (x >= count);
    return x;
}

sure_case make_integers(sure_shape shape, rng *g)
{
    uint64_t count = regime_integers_count(shape);
    uint64_t code = shuffle_below(g->number % count, count, g);
    sure_case c = {.ray = take_ray(&code), .object.shape = shape};
    case_shape_of(shape)->small_object(&c, code);
    return c;
}

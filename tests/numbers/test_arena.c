/* SPDX-License-Identifier: MIT */
/* Does the exact stage's arena hold the longest numbers that there are? The stage itself, compiled
 * here so that the arena stays where it can be looked at, is asked about coordinates of all
 * magnitudes at once. A number too many ends the program (exact.c). */
#include "../support/objects.h"
#include "../support/suite.h"
#include "../support/test_shape.h"

#include "../../src/numbers/exact.h"
#include "../../src/stages/rows.h"

/* The arena is filled with a pattern before a question; what differs afterwards was used. */
static const exact_limb untouched = (exact_limb)0x5eedfacecafe1234;
static exact_arena *watched;

static exact_context start_watched(exact_arena *room)
{
    watched = room;
    for (size_t i = 0; i < EXACT_LIMBS; i++)
        room->limbs[i] = untouched;
    return exact_start(room);
}

#define exact_arena static exact_arena
#define exact_start start_watched
#include "../../src/stages/hits/rounded.c"
#include "../../src/stages/last/last.c"
#undef exact_arena
#undef exact_start

static size_t limbs_used(void)
{
    size_t count = EXACT_LIMBS;
    while (count > 0 && watched->limbs[count - 1] == untouched)
        count--;
    return count;
}

static double draw_of(rng *d, int low, int high)
{
    double mantissa = 1 + rng_between(d, 0, 1);
    int exponent = rng_integer(d, low, high);
    return rng_sign(d) * ldexp(mantissa, exponent);
}

/* Odd multiples of the least double. */
static double draw_tiny(rng *d)
{
    return rng_sign(d) * ldexp(2 * rng_whole(d, 51) + 1, -1074);
}

static double draw_huge(rng *d)
{
    return draw_of(d, rng_chance(d, 1, 4) ? -300 : 1000, 1021);
}

static double draw_step(rng *d)
{
    int kind = rng_integer(d, 0, 2);
    return kind == 0 ? draw_tiny(d) : draw_of(d, kind == 1 ? 900 : -1000, 1023);
}

static sure_vec3 draw_vector(rng *d, double (*draw)(rng *))
{
    double x = draw(d), y = draw(d), z = draw(d);
    return (sure_vec3){x, y, z};
}

/* Across v but for the least there is, or of all magnitudes at once. */
static sure_vec3 draw_direction(rng *d, sure_vec3 v)
{
    if (rng_chance(d, 1, 2))
        return (sure_vec3){-v.y / 4, v.x / 4, draw_tiny(d)};
    return draw_vector(d, draw_step);
}

/* An object that has `middle` inside or nearly, from next to 0 to beyond there. */
static sure_object draw_object(rng *d, sure_shape shape, sure_vec3 middle)
{
    sure_vec3 here = draw_vector(d, draw_tiny), there = times(rng_between(d, 1.1, 1.9), middle);
    double radius = fabs(draw_of(d, 1010, 1023));
    sure_vec3 normal = draw_vector(d, draw_huge);
    bool turned = rng_chance(d, 1, 2);
    return object_made(shape, turned ? there : here, normal, turned ? here : there, radius);
}

/* Limbs used at most by the hit, the interval, the normal, the point and the order. */
enum { QUESTIONS = 5, CASES = 300 };
static size_t most[QUESTIONS];

static void note(int question)
{
    size_t used = limbs_used();
    most[question] = used > most[question] ? used : most[question];
}

static bool ask(const sure_ray *ray, const sure_object *object)
{
    sure_hit hit;
    sure_interval interval;
    const shape_row *row = row_of(object);
    const void *shape = &object->as;
    const sure_status status = stages_last_hit(row, ray, shape, T_CERTAIN, &hit);
    note(0);
    (void)stages_last_interval(row, ray, shape, &interval);
    note(1);
    if (status != SURE_HIT)
        return false;
    (void)rounded_normal(ray, row, shape);
    note(2);
    (void)rounded_point(ray, row, shape);
    note(3);
    return true;
}

static void ask_order(const sure_ray *ray, const sure_object *first, const sure_object *second)
{
    const shape_row *row = row_of(first), *other = row_of(second);
    int forth = rounded_order(ray, row, &first->as, other, &second->as);
    note(4);
    int back = rounded_order(ray, other, &second->as, row, &first->as);
    note(4);
    ck_assert_int_eq(forth, -back);
}

LOOP_TEST(test_arena, SURE_SHAPES)
{
    unsigned hits = 0, pairs = 0;
    for (int question = 0; question < QUESTIONS; question++)
        most[question] = 0;
    for (uint64_t index = 0; index < CASES; index++) {
        rng d = rng_of(12, (uint64_t)_i, 105, index);
        sure_vec3 middle = draw_vector(&d, draw_huge);
        double t_min = fabs(draw_tiny(&d));
        sure_ray ray = {middle, draw_direction(&d, middle), t_min, INFINITY};
        sure_object object = draw_object(&d, (sure_shape)_i, middle);
        if (!ask(&ray, &object))
            continue;
        hits++;
        for (int shape = 0; shape < SURE_SHAPES; shape++) {
            sure_object other = draw_object(&d, (sure_shape)shape, middle);
            if (ask(&ray, &other)) {
                pairs++;
                ask_order(&ray, &object, &other);
            }
        }
    }
    printf(
        "%-8s %u hits, %u pairs; limbs: hit %zu, interval %zu, normal %zu, point %zu, order %zu\n",
        sure_shape_name((sure_shape)_i), hits, pairs, most[0], most[1], most[2], most[3], most[4]);
    fflush(stdout);
    ck_assert_uint_gt(hits, CASES / 10);
    ck_assert_uint_gt(pairs, CASES / 10);
}

SUITE("arena")

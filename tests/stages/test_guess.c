/* SPDX-License-Identifier: MIT */
/* Most numbers of an exact answer are rounded by a guess whose bound leaves one double: the others
 * are held against midpoints, which says the same. A good guess leaves the two beside the number's
 * double, those of the next double where it was off by one, and a tie. */
#include "every_case.h"

#include "../../src/stages/hits/beyond.h"
#include "../../src/stages/last/guess.h"
#include "../../src/stages/rows.h"

/* Rounding, so that it can be watched: where a guess is used, and where a midpoint is halved. */
static int questions, most_questions;
static unsigned long roundings, known;
static bool doubted;       /* is no guess believed? */
static double spoiled = 1; /* what a guess is multiplied by then */

static bool watched_rounds(const exact_context *c, wide guess, double *rounded)
{
    most_questions = questions > most_questions ? questions : most_questions;
    questions = 0;
    roundings++;
    bool one = wide_rounds(c, guess, rounded);
    known += one;
    if (doubted)
        *rounded *= spoiled;
    return one && !doubted;
}

static exact watched_scaled(exact_context *c, int64_t mantissa, int exponent)
{
    questions += exponent == -1;
    return exact_scaled(c, mantissa, exponent);
}

#undef wide_rounds
#define wide_rounds watched_rounds
#undef exact_scaled
#define exact_scaled watched_scaled
#include "../../src/stages/last/rounding.c"

enum { CASES = 150, SEED = 31, MOST = 4 };

typedef struct {
    double t;
    sure_vec3 point, normal;
} rounded;

static rounded round_all(const sure_case *q)
{
    const void *shape = &q->object.as;
    const shape_row *row = row_of(&q->object);
    return (rounded){odd_t(&q->ray, row, shape), rounded_point(&q->ray, row, shape),
                     rounded_normal(&q->ray, row, shape)};
}

LOOP_TEST(test_few_questions, SURE_SHAPES)
{
    unsigned long hits = 0, numbers = 0, by_guess = 0;
    bool is_curved = false;
    most_questions = 0;
    sure_hit hit;
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, CASES); walk_next(&w);) {
        const sure_ray *ray = &w.asked.ray;
        const sure_object *object = &w.asked.object;
        if (sure_object_hit(ray, object, SURE_TIER_CERTAIN, &hit) != SURE_HIT)
            continue;
        hits++;
        is_curved = row_of(object)->surface->slope != NULL;
        questions = 0; /* what made the case is not counted */
        const unsigned long before = roundings, known_before = known;
        (void)round_all(&w.asked);
        numbers += roundings - before;
        by_guess += known - known_before;
        ck_assert_msg(questions <= MOST && most_questions <= MOST, "%d, %d questions: %s",
                      questions, most_questions, case_text(&w.asked));
    }
    printf("%-8s %lu hits, %lu numbers, %lu by their guess, else at most %d questions\n",
           sure_shape_name((sure_shape)_i), hits, numbers, by_guess, most_questions);
    fflush(stdout);
    ck_assert_uint_gt(hits, CASES);
    ck_assert(numbers > hits || !is_curved);
    ck_assert(5 * by_guess > 4 * numbers || numbers == 0);
}

/* Midpoints say what the guess said, and from wherever the search begins it ends at the same
 * place. */
LOOP_TEST(test_any_guess_is_as_good, SURE_SHAPES)
{
    const double factors[] = {1, 1 + 0x1p-50, 1 - 0x1p-30, 0.5, -1, 0, 0x1p600};
    unsigned long hits = 0;
    sure_hit hit;
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, 4 * CASES); walk_next(&w);) {
        const sure_case *q = &w.asked;
        if (sure_object_hit(&q->ray, &q->object, SURE_TIER_CERTAIN, &hit) != SURE_HIT)
            continue;
        const rounded right = round_all(q);
        size_t all = hits++ % 40 == 0 ? sizeof factors / sizeof *factors : 1;
        for (size_t i = 0; i < all; i++) {
            doubted = true;
            spoiled = factors[i];
            const rounded other = round_all(q);
            doubted = false;
            ck_assert_msg(memcmp(&other, &right, sizeof right) == 0, "guesses times %a: %s",
                          factors[i], case_text(q));
        }
    }
    ck_assert_uint_gt(hits, CASES);
}

SUITE("guess")

/* SPDX-License-Identifier: MIT */
/* The two oracles against each other, bit for bit: the CGAL reference and the bisection oracle
 * share no code and no formula. Every regime of every shape, SUREHIT_ORACLE_CASES cases a shape
 * (5000 unless set) of seed SUREHIT_ORACLE_SEED (1 unless set). */
#include "../../reference/reference.h"

#include "../support/every_case.h"
#include "oracle.h"

static unsigned long hits, pairs, ties;

static void expect_sign(const sure_case *question, const char *what, int bisection, int reference)
{
    ck_assert_msg(bisection == reference, "%s: bisection %d, reference %d: %s", what, bisection,
                  reference, case_text(question));
}

static void compare_answers(const sure_case *question)
{
    bisection_result bisection = oracles[0].answer(question);
    bisection_result reference = oracles[1].answer(question);
    hits += bisection.status == SURE_HIT;
    bisection_expect(question, &reference, &bisection, "the oracles disagree");
    const double x[] = {bisection.t, question->ray.t_min, question->ray.t_max};
    for (int i = 0; i < 3 && bisection.status == SURE_HIT; i++)
        expect_sign(question, "sign of t* - x", oracles[0].compare(question, x[i]),
                    oracles[1].compare(question, x[i]));
}

/* The order of one ray's hits on two objects, where it has both. */
static void compare_order(const sure_case *question, const sure_object *second)
{
    const sure_case other = {.ray = question->ray, .object = *second};
    int bisection = REFERENCE_NONE;
    int reference = oracles[1].order(&question->ray, &question->object, second);
    bool both = oracles[0].answer(question).status == SURE_HIT &&
                oracles[0].answer(&other).status == SURE_HIT;
    if (both)
        bisection = oracles[0].order(&question->ray, &question->object, second);
    pairs += both;
    ties += bisection == 0;
    expect_sign(question, "order of this and another object", bisection, reference);
}

/* The object with its last number moved by one step: an order that seldom shows in doubles. */
static sure_object nudged(const sure_case *question)
{
    sure_case moved = *question;
    double *last = case_number(&moved, case_numbers(question->object.shape) - 1);
    *last = nextafter(*last, (double)INFINITY);
    return moved.object;
}

LOOP_TEST(regimes_agree, SURE_SHAPES)
{
    sure_shape shape = (sure_shape)_i;
    uint64_t regimes = 0, seed = suite_setting("SUREHIT_ORACLE_SEED", 1);
    for (int which = 0; which < REGIMES; which++)
        regimes += regime_applies(shape, (regime)which) ? 1 : 0;
    uint64_t count = (suite_setting("SUREHIT_ORACLE_CASES", 5000) + regimes - 1) / regimes;
    for (case_walk w = walk_regimes(shape, seed, count); walk_next(&w);) {
        /* A tie in integers and close to one elsewhere: one root of two polynomials. */
        sure_object near = nudged(&w.asked);
        sure_object same = test_shape_of(shape)->companion(&w.asked.ray, &w.asked.object);
        sure_shape other = (sure_shape)(((uint64_t)shape + 1 + w.index) % SURE_SHAPES);
        compare_answers(&w.asked);
        compare_order(&w.asked, &near);
        compare_order(&w.asked, &same);
        if (regime_applies(other, w.which)) {
            sure_object third = regime_case(other, w.which, seed, w.index).object;
            compare_order(&w.asked, &third);
        }
    }
    ck_assert(hits > count && pairs > count && ties > 0);
}

SUITE("oracles")

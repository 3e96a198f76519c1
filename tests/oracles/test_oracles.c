/* The two oracles against each other, bit for bit: the CGAL reference and the bisection oracle
 * share no code and no formula. Every regime of every shape, SUREHIT_ORACLE_CASES cases a shape
 * (5000 unless set) of seed SUREHIT_ORACLE_SEED (1 unless set). */
#include "../../reference/reference.h"

#include "regimes.h"
#include "../support/bisection_result.h"
#include "../support/every_case.h"
#include "../support/suite.h"
#include "../support/test_shape.h"
#include "oracle.h"

#include <math.h>
#include <stdio.h>

typedef struct {
    unsigned long cases, hits, misses, invalid, pairs, ties;
} tally;

static void expect_sign(const sure_case *question, const char *what, int bisection, int reference)
{
    ck_assert_msg(bisection == reference, "%s: bisection %d, reference %d: %s", what, bisection,
                  reference, case_text(question));
}

static void compare_answers(const sure_case *question, tally *total)
{
    bisection_result bisection = oracles[0].answer(question);
    bisection_result reference = oracles[1].answer(question);
    total->cases++;
    total->hits += bisection.status == SURE_HIT;
    total->misses += bisection.status == SURE_MISS;
    total->invalid += bisection.status == SURE_INVALID;
    bisection_expect(question, &reference, &bisection, "the oracles disagree");
    const double x[] = {bisection.t, question->ray.t_min, question->ray.t_max};
    for (int i = 0; i < 3 && bisection.status == SURE_HIT; i++)
        expect_sign(question, "sign of t* - x", oracles[0].compare(question, x[i]),
                    oracles[1].compare(question, x[i]));
}

/* The order of one ray's hits on two objects, where it has both. */
static void compare_order(const sure_case *question, const sure_object *second, tally *total)
{
    const sure_case other = {question->ray, *second};
    int bisection = REFERENCE_NONE;
    int reference = oracles[1].order(&question->ray, &question->object, second);
    bool both = oracles[0].answer(question).status == SURE_HIT &&
                oracles[0].answer(&other).status == SURE_HIT;
    if (both)
        bisection = oracles[0].order(&question->ray, &question->object, second);
    total->pairs += both;
    total->ties += bisection == 0;
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

static void compare_case(const sure_case *question, sure_shape other_shape, regime which,
                         uint64_t seed, uint64_t index, tally *total)
{
    /* A tie in integers and close to one elsewhere: one root of two polynomials. */
    sure_object near = nudged(question);
    sure_object same =
        test_shape_of(question->object.shape)->companion(&question->ray, &question->object);
    compare_answers(question, total);
    compare_order(question, &near, total);
    compare_order(question, &same, total);
    if (regime_applies(other_shape, which)) {
        sure_object other = regime_case(other_shape, which, seed, index).object;
        compare_order(question, &other, total);
    }
}

static unsigned long applicable_regimes(sure_shape shape)
{
    unsigned long count = 0;
    for (int which = 0; which < REGIMES; which++)
        count += regime_applies(shape, (regime)which) != 0;
    return count;
}

LOOP_TEST(regimes_agree, SURE_SHAPES)
{
    sure_shape shape = (sure_shape)_i;
    unsigned long regimes = applicable_regimes(shape),
                  seed = suite_setting("SUREHIT_ORACLE_SEED", 1);
    unsigned long cases = (suite_setting("SUREHIT_ORACLE_CASES", 5000) + regimes - 1) / regimes;
    for (int i = 0; i < REGIMES; i++) {
        regime which = (regime)i;
        tally total = {0};
        for (uint64_t index = 0; regime_applies(shape, which) && index < cases; index++) {
            sure_case question = regime_case(shape, which, seed, index);
            sure_shape other = (sure_shape)(((uint64_t)shape + 1 + index) % SURE_SHAPES);
            compare_case(&question, other, which, seed, index, &total);
        }
        if (total.cases > 0)
            printf("%-8s %-13s %7lu cases: %lu hit, %lu miss, %lu invalid; %lu pairs, %lu ties\n",
                   sure_shape_name(shape), regime_name(which), total.cases, total.hits,
                   total.misses, total.invalid, total.pairs, total.ties);
    }
}

SUITE("oracles")

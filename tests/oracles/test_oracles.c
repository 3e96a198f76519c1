/* The two oracles against each other, bit for bit: the CGAL reference and the bisection oracle
 * share no code and no formula. Every regime of every shape, SUREHIT_ORACLE_CASES cases a shape
 * (5000 unless set) of seed SUREHIT_ORACLE_SEED (1 unless set). */
#include "../../reference/bisection.h"
#include "../../reference/reference.h"

#include "regimes.h"
#include "../support/bisection_result.h"
#include "../support/suite.h"
#include "../support/test_shape.h"
#include "oracle.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DISAGREEMENTS_SHOWN 10

typedef struct {
    unsigned long cases, hits, misses, invalid, pairs, ties, disagreements;
} tally;

static unsigned long setting(const char *name, unsigned long otherwise)
{
    const char *text = getenv(name);
    char *end;
    if (!text)
        return otherwise;
    errno = 0;
    unsigned long value = strtoul(text, &end, 10);
    ck_assert_msg(errno == 0 && end != text && *end == '\0', "%s=%s is no number", name, text);
    return value;
}

static void disagree(tally *total, const sure_case *question, const char *what,
                     const char *bisection, const char *reference)
{
    char line[CASE_LINE_MAX];
    if (total->disagreements++ >= DISAGREEMENTS_SHOWN)
        return;
    case_print(question, line);
    printf("%s\n  %s\n    bisection %s\n    reference %s\n", line, what, bisection, reference);
}

static void disagree_on_sign(tally *total, const sure_case *question, const char *what,
                             int bisection, int reference)
{
    char first[16], second[16];
    snprintf(first, sizeof first, "%d", bisection);
    snprintf(second, sizeof second, "%d", reference);
    disagree(total, question, what, first, second);
}

/* The sign of t* - x at the answer itself and at the range's ends. */
static void compare_signs(const sure_case *question, double t, tally *total)
{
    const sure_ray *ray = &question->ray;
    const double x[] = {t, ray->t_min, ray->t_max};
    for (size_t i = 0; i < sizeof x / sizeof x[0]; i++) {
        int reference = REFERENCE_NONE;
        reference_compare_hit(ray, &question->object, x[i], &reference);
        int bisection = bisection_compare(ray, &question->object, x[i]);
        if (bisection != reference)
            disagree_on_sign(total, question, "sign of t* - x", bisection, reference);
    }
}

static void compare_answers(const sure_case *question, tally *total)
{
    bisection_result bisection = oracles[0].answer(question);
    bisection_result reference = oracles[1].answer(question);
    total->cases++;
    total->hits += bisection.status == SURE_HIT;
    total->misses += bisection.status == SURE_MISS;
    total->invalid += bisection.status == SURE_INVALID;
    if (!bisection_same(&bisection, &reference)) {
        char first[RESULT_TEXT_MAX], second[RESULT_TEXT_MAX];
        bisection_print(&bisection, first);
        bisection_print(&reference, second);
        disagree(total, question, "answer", first, second);
    } else if (bisection.status == SURE_HIT) {
        compare_signs(question, bisection.t, total);
    }
}

/* The order of one ray's hits on two objects, where it has both. */
static void compare_order(const sure_case *question, const sure_object *second, tally *total)
{
    const sure_ray *ray = &question->ray;
    const sure_object *first = &question->object;
    int bisection = REFERENCE_NONE, reference = REFERENCE_NONE;
    bisection_result result;
    bool both = bisection_answer(ray, first, &result) == SURE_HIT &&
                bisection_answer(ray, second, &result) == SURE_HIT;
    if (both)
        bisection = bisection_order(ray, first, second);
    reference_hit_order(ray, first, second, &reference);
    total->pairs += both;
    total->ties += bisection == 0;
    if (bisection != reference) {
        sure_case other = {*ray, *second};
        disagree_on_sign(total, question, "order of this and the following", bisection, reference);
        disagree_on_sign(total, &other, "the following", bisection, reference);
    }
}

/* The object with its last number moved by one step: an order that seldom shows in doubles. */
static sure_object nudged(const sure_case *question)
{
    double numbers[CASE_NUMBERS_MAX];
    int last = case_numbers(question->object.shape) - 1;
    case_to_numbers(question, numbers);
    numbers[last] = nextafter(numbers[last], (double)INFINITY);
    return case_from_numbers(question->object.shape, numbers).object;
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

static void print_tally(sure_shape shape, const char *name, const tally *t)
{
    printf("%-8s %-13s %7lu cases: %lu hit, %lu miss, %lu invalid; %lu pairs, %lu ties; "
           "%lu disagreements\n",
           sure_shape_name(shape), name, t->cases, t->hits, t->misses, t->invalid, t->pairs,
           t->ties, t->disagreements);
    fflush(stdout);
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
    unsigned long regimes = applicable_regimes(shape), seed = setting("SUREHIT_ORACLE_SEED", 1);
    unsigned long cases = (setting("SUREHIT_ORACLE_CASES", 5000) + regimes - 1) / regimes;
    unsigned long disagreements = 0;
    ck_assert_uint_gt(cases, 0);
    for (int i = 0; i < REGIMES; i++) {
        regime which = (regime)i;
        tally total = {0};
        for (uint64_t index = 0; regime_applies(shape, which) && index < cases; index++) {
            sure_case question = regime_case(shape, which, seed, index);
            sure_shape other = (sure_shape)(((uint64_t)shape + 1 + index) % SURE_SHAPES);
            compare_case(&question, other, which, seed, index, &total);
        }
        if (total.cases > 0)
            print_tally(shape, regime_name(which), &total);
        disagreements += total.disagreements;
    }
    ck_assert_uint_eq(disagreements, 0);
}

SUITE("oracles")

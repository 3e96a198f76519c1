/* SPDX-License-Identifier: MIT */
/* The same answers in every floating-point environment: rounding mode, flushing of subnormals. And
 * in every build: the printed digests of all answers in the default environment are compared by
 * test_builds.py, which compiles the library, and this file, in many ways. Argument: cases of
 * each regime of each shape.
 *
 * exact: the same bits. certain: the same decisions, t within its error. The environment is found
 * as it was left after each call. */
#include "regimes.h"

#include "../support/answers.h"
#include "../support/surroundings.h"

#include <inttypes.h>
#include <stdlib.h>

#include <surehit/surehit.h>

enum { SEED = 3, SHOWN = 10, USUAL = 0 };

static unsigned long failures;

static int environment; /* asked in */
static bool kept;       /* the environment, since then */

static void look(void)
{
    kept = kept && surroundings_kept(environment);
}

static answers ask(const sure_case *question, sure_tier tier, int in)
{
    environment = in;
    kept = true;
    surroundings_enter(in);
    answers found = answers_of(question, tier, look);
    surroundings_enter(USUAL);
    return found;
}

static void fail(const sure_case *question, int in, sure_tier tier, const char *what)
{
    char line[CASE_LINE_MAX];
    if (failures++ >= SHOWN)
        return;
    case_print(question, line);
    printf("%s\n  %s, %s: %s\n", line, sure_tier_name(tier), surroundings_name(in), what);
}

/* By its bits: the compiler may have been told that there are none but numbers. */
static bool is_number(double x)
{
    uint64_t word;
    memcpy(&word, &x, sizeof word);
    return (word & ~(UINT64_C(1) << 63)) < UINT64_C(0x7ff) << 52;
}

/* The distance to the next double above the magnitude, in long double, which nothing flushes. */
static long double step_at(double x)
{
    uint64_t word;
    double next;
    memcpy(&word, &x, sizeof word);
    word &= ~(UINT64_C(1) << 63);
    memcpy(&x, &word, sizeof x);
    word++;
    memcpy(&next, &word, sizeof next);
    return is_number(next) ? (long double)next - (long double)x : 0x1p971L;
}

/* Can |t - t*| <= error be, when t* is rounded to `rounded`? Not for sure where it says yes; the
 * campaign settles that, in one environment. */
static bool may_be_within(double t, double error, double rounded)
{
    if (!is_number(t) || !is_number(rounded) || !is_number(error))
        return memcmp(&t, &rounded, sizeof t) == 0;
    long double apart = (long double)t - (long double)rounded;
    return (apart < 0 ? -apart : apart) <= (long double)error + step_at(rounded);
}

static void compare_exact(const sure_case *question, int in, const answers *truth,
                          const answers *found)
{
    if (!answers_same(truth, *found))
        fail(question, in, SURE_TIER_EXACT, "another answer");
    if (!may_be_within(found->hit.t, found->hit.t_error, truth->hit.t))
        fail(question, in, SURE_TIER_EXACT, "t_error");
}

static void compare_certain(const sure_case *question, int in, const answers *truth,
                            const answers *found)
{
    if (!answers_same_decisions(truth, found))
        fail(question, in, SURE_TIER_CERTAIN, "another decision");
    else if (!may_be_within(found->hit.t, found->hit.t_error, truth->hit.t))
        fail(question, in, SURE_TIER_CERTAIN, "t_error");
    if (!may_be_within(found->normal.x, SURE_NORMAL_ERROR, truth->normal.x) ||
        !may_be_within(found->normal.y, SURE_NORMAL_ERROR, truth->normal.y) ||
        !may_be_within(found->normal.z, SURE_NORMAL_ERROR, truth->normal.z))
        fail(question, in, SURE_TIER_CERTAIN, "normal");
}

typedef struct {
    uint64_t exact, certain; /* digests */
    unsigned long cases, other_error, other_certain;
} summary;

static uint64_t digested(uint64_t digest, const answers *found)
{
    uint64_t words[sizeof *found / sizeof(uint64_t)];
    memcpy(words, found, sizeof words);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        digest = ((digest ^ words[i]) * UINT64_C(0x100000001b3)) ^ digest >> 29;
    return digest;
}

static void try_case(const sure_case *question, summary *sum)
{
    answers exact = ask(question, SURE_TIER_EXACT, USUAL);
    answers certain = ask(question, SURE_TIER_CERTAIN, USUAL);
    sum->cases++;
    sum->exact = digested(sum->exact, &exact);
    sum->certain = digested(sum->certain, &certain);
    compare_certain(question, USUAL, &exact, &certain);
    for (int in = 0; in < SURROUNDINGS; in++) {
        answers found = ask(question, SURE_TIER_EXACT, in);
        compare_exact(question, in, &exact, &found);
        sum->other_error += memcmp(&found, &exact, sizeof found) != 0;
        bool kept_by_exact = kept;
        found = ask(question, SURE_TIER_CERTAIN, in);
        compare_certain(question, in, &exact, &found);
        sum->other_certain += memcmp(&found, &certain, sizeof found) != 0;
        if (!kept_by_exact || !kept)
            fail(question, in, SURE_TIER_EXACT, "the environment is changed");
    }
}

/* Every tier calls it invalid everywhere, flushed subnormals or not. */
static void require_invalid(const sure_case *question)
{
    for (int i = 0; i < SURE_TIERS * SURROUNDINGS; i++) {
        int in = i % SURROUNDINGS;
        sure_tier tier = (sure_tier)(i / SURROUNDINGS);
        answers found = ask(question, tier, in);
        if (found.status != SURE_INVALID || found.interval_status != SURE_INVALID ||
            found.occluded != SURE_INVALID)
            fail(question, in, tier, "not invalid");
    }
}

/* A subnormal too little: in the range, and in the radius where there is one. */
static void try_subnormals(sure_shape shape)
{
    const double below = -0x1p-1060;
    const int last = case_numbers(shape) - 1;
    sure_case question = regime_case(shape, REGIME_TYPICAL, SEED, 0), thinner = question;
    question.ray.t_min = below;
    require_invalid(&question);
    question.ray.t_min = 0x1p-1060;
    question.ray.t_max = 0x1p-1061;
    require_invalid(&question);
    *case_number(&thinner, last) = below;
    if (field_at(shape, last)->kind == SURE_KIND_RADIUS)
        require_invalid(&thinner);
}

/* Where numbers are 0 they are next to nothing, which is no less exact: flushed, an axis that is
 * nearly along a coordinate's would be along it. */
static bool with_subnormals(sure_case *question)
{
    const sure_shape shape = question->object.shape;
    bool changed = false;
    for (int i = 0; i < case_numbers(shape); i++) {
        double *x = case_number(question, i);
        uint64_t word, sign = (uint64_t)(i % 2) << 63;
        memcpy(&word, x, sizeof word);
        if (word << 1 != 0 || case_number_kind(shape, i) == IS_TIME)
            continue;
        word = sign | (uint64_t)(1 + i % 3) << 34; /* 2^-1040, 2^-1039, 3 2^-1040 */
        memcpy(x, &word, sizeof word);
        changed = true;
    }
    object_mend(shape, case_number(question, AT_OBJECT));
    return changed;
}

int main(int argc, char **argv)
{
    uint64_t cases = argc == 2 ? strtoull(argv[1], NULL, 10) : 0;
    summary sum = {0};
    if (cases == 0) {
        fprintf(stderr, "usage: test_environments CASES\n");
        return 2;
    }
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        try_subnormals(shape);
        for (regime r = 0; r < REGIMES; r++) {
            for (uint64_t i = 0; regime_applies(shape, r) && i < cases; i++) {
                surroundings_enter(USUAL);
                sure_case question = regime_case(shape, r, SEED, i);
                try_case(&question, &sum);
                if (with_subnormals(&question))
                    try_case(&question, &sum);
            }
        }
    }
    printf("exact %016" PRIx64 "\ncertain %016" PRIx64 "\n", sum.exact, sum.certain);
    printf("%lu cases, %d environments; of exact %lu other t_error, of certain %lu other answers\n",
           sum.cases, SURROUNDINGS, sum.other_error, sum.other_certain);
    printf("%d passed, %d failed\n", failures == 0, failures != 0);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

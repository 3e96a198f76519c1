/* SPDX-License-Identifier: MIT */
/* The referee's accusations, each asked of the reference as well: margins CASES SEED
 *
 * What the tiers float32 and textbook decide wrongly, so many cases a shape and regime, is held
 * against the referee's margins: wrong for each object between a larger and a smaller one. The
 * same verdict is formed from the reference's answers about these objects, which share no code with
 * the tier exact. Prints how many accusations there are; fails where one is not confirmed, or where
 * the reference accuses and the referee does not. */
#include "margin.h"
#include "reference.h"
#include "regimes.h"

#include "../../src/cases/moved.h"
#include "../../src/numbers/sums.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static sure_status reference_first(const sure_ray *ray, const sure_object *object, sure_hit *hit)
{
    sure_vec3 normal;
    return reference_hit(ray, object, &hit->t, &hit->part, &normal);
}

/* No case here is of a wall. */

static bool reference_is_hit(const sure_case *question, const sure_ray *ray)
{
    return reference_occluded(ray, &question->object) == SURE_HIT;
}

static bool reference_starts_within(const sure_case *question, const sure_ray *ray)
{
    sure_interval unused;
    sure_ray start = *ray;
    start.t_max = start.t_min;
    return reference_interval(&start, &question->object, &unused) == SURE_HIT;
}

/* The referee's own reasons, by other answers. */
extern const char *const confirmed_unit_names[];
double confirmed_length(const sure_case *question, margin_unit unit, precision in);
movement confirmed_way(const sure_case *question, margin_unit unit, precision in);
fault confirmed_fault(unsigned faults);
bool confirmed_beyond(const sure_case *question, fault which, const reply *given,
                      const movement *way);
bool confirmed_beyond_length(const sure_case *question, fault which, const reply *given, double by);
double confirmed_of(const sure_case *question, fault which, const reply *given, double least,
                    double below, double enough, const movement *unit);
bool confirmed_of_end(const sure_case *question, double by);
#define margin_unit_names confirmed_unit_names
#define margin_length confirmed_length
#define margin_fault confirmed_fault
#define margin_way confirmed_way
#define margin_beyond confirmed_beyond
#define margin_beyond_length confirmed_beyond_length
#define margin_of confirmed_of
#define margin_of_end confirmed_of_end
#define sure_object_occluded(ray, object, tier) reference_occluded(ray, object)
#define case_is_hit reference_is_hit
#define case_starts_within reference_starts_within
#define sure_object_hit(ray, object, tier, hit) reference_first(ray, object, hit)
#include "../../src/judge/referee/margin.c"
#undef margin_length
#undef margin_fault
#undef margin_way
#undef margin_beyond
#undef margin_beyond_length
#undef margin_of_end
#undef case_is_hit
#undef case_starts_within
#undef sure_object_hit

static const double sizes[] = {1e-12, 1e-9, 1e-6, 1e-3, 1e-2, 1};
enum { SIZES = sizeof sizes / sizeof *sizes };

static uint64_t asked, wrong, accused[SIZES], outgrown[SIZES], ends, refuted;

static void refute(const char *what, double size, const char *of, const sure_case *question)
{
    char line[CASE_LINE_MAX];
    case_print(question, line);
    printf("%s at %g, %s: %s\n", what, size, of, line);
    refuted++;
}

/* Which end is hit. */
static void weigh_end(const sure_case *question)
{
    double unit = margin_length(question, MARGIN_SIZE, PRECISION_DOUBLE);
    for (int i = 0; i < SIZES; i++) {
        bool is = margin_of_end(question, sizes[i] * unit);
        ends += is;
        if (confirmed_of_end(question, sizes[i] * unit) != is)
            refute("not agreed", sizes[i], "end", question);
    }
}

static void weigh(const sure_case *question, fault which, const reply *given, margin_unit unit,
                  uint64_t counts[SIZES])
{
    const movement once = margin_way(question, unit, PRECISION_DOUBLE);
    bool is = true;
    for (int i = 0; i < SIZES && is; i++) {
        const movement way = movement_times(&once, sizes[i]);
        is = margin_beyond(question, which, given, &way);
        counts[i] += is;
        if (confirmed_beyond(question, which, given, &way) == is)
            continue;
        refute(is ? "not confirmed" : "not accused", sizes[i], fault_name(which), question);
    }
}

static void ask(const sure_case *question, sure_tier tier)
{
    case_answer right = case_answer_of(question, SURE_TIER_EXACT);
    sure_hit hit = {.part = 0};
    reply given = {.status = sure_object_hit(&question->ray, &question->object, tier, &hit)};
    given.t = hit.t;
    given.part = (int)hit.part;
    fault which = margin_fault(faults_of(question, &right, &given));
    asked++;
    if (right.status == SURE_INVALID || which > FAULT_WRONG_PART)
        return;
    wrong++;
    weigh(question, which, &given, MARGIN_SIZE, accused);
    weigh(question, which, &given, MARGIN_GROWTH, outgrown);
}

int main(int count, char **words)
{
    uint64_t cases = count == 3 ? strtoull(words[1], NULL, 10) : 0;
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++) {
        sure_shape shape = (sure_shape)(i / REGIMES);
        regime which = (regime)(i % REGIMES);
        for (uint64_t n = 0; n < cases && regime_applies(shape, which); n++) {
            sure_case question = regime_case(shape, which, strtoull(words[2], NULL, 10), n);
            ask(&question, SURE_TIER_FLOAT32);
            ask(&question, SURE_TIER_TEXTBOOK);
            weigh_end(&question);
        }
    }
    printf("%" PRIu64 " answers, %" PRIu64 " decisions wrong\n", asked, wrong);
    for (int i = 0; i < SIZES; i++)
        printf("by more than %g: %" PRIu64 ", as growth %" PRIu64 "\n", sizes[i], accused[i],
               outgrown[i]);
    printf("accusations that the reference does not share: %" PRIu64 "\n", refuted);
    printf("hits whose end is in question: %" PRIu64 "\n", ends);
    return refuted > 0 || accused[0] == 0 || outgrown[0] == 0 || ends == 0;
}

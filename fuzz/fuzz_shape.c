/* One ray and one shape, FUZZ_SHAPE: everything that the contract promises of hit, interval,
 * occluded and normal of every tier. */
#include "fuzz.h"

#include "campaign_check.h"
#include "shape_bytes.h"
#include "shape_laws.h"
#include "surroundings.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char fuzz_name[] = FUZZ_SHAPE;

size_t (*const fuzz_mutator)(uint8_t *, size_t, size_t, unsigned) = fuzz_mutate_doubles;

static void find(const sure_case *question, const char *law)
{
    fuzz_find(law, fuzz_case_text(question));
}

/* Some of the checks cost more than all others together: see fuzz_draws. */
typedef struct {
    campaign_more more;
    bool again;
    sure_tier laws; /* SURE_TIERS for none */
    int environment;
} choice;

static choice draw_choice(uint64_t draws, uint64_t cost)
{
    choice c = {.laws = SURE_TIERS};
    c.more.interval = fuzz_drawn(&draws, 4);
    c.more.occluded = fuzz_drawn(&draws, 8);
    c.more.normal = fuzz_drawn(&draws, 8 * cost);
    c.again = fuzz_drawn(&draws, 16 * cost);
    c.environment = (int)(draws % SURROUNDINGS);
    draws /= SURROUNDINGS;
    if (fuzz_drawn(&draws, 8))
        c.laws = (sure_tier)(draws % SURE_TIERS);
    if (c.laws == SURE_TIER_CERTAIN || c.laws == SURE_TIER_EXACT) {
        draws /= SURE_TIERS;
        c.laws = fuzz_drawn(&draws, 2 * cost) ? c.laws : SURE_TIERS;
    }
    return c;
}

/* The laws that the headers number. */
static void check_laws(const sure_case *question, sure_tier tier)
{
    unsigned long checked = 0;
    const char *broken = shape_law_broken(question, tier, &checked);
    char law[160];
    if (!broken)
        return;
    snprintf(law, sizeof law, "%s: %s", sure_tier_name(tier), broken);
    find(question, law);
}

typedef struct {
    sure_status status, chord;
    sure_hit hit; /* where there is none, the bytes from before */
    sure_vec3 normal;
    sure_interval ends;
    sure_stage stage;
} answer;

static answer ask(const sure_case *question, sure_tier tier, int environment)
{
    answer a;
    memset(&a, 0xa5, sizeof a);
    surroundings_set(environment);
    a.status = sure_object_hit(&question->ray, &question->object, tier, &a.hit);
    if (a.status == SURE_HIT)
        a.normal = sure_object_normal(&question->ray, &question->object, tier, &a.hit);
    a.chord = sure_object_interval(&question->ray, &question->object, tier, &a.ends);
    a.stage = sure_object_stage(&question->ray, &question->object, tier);
    surroundings_set(0);
    return a;
}

static bool same_parts(const answer *a, const answer *b)
{
    return a->ends.enter_part == b->ends.enter_part && a->ends.leave_part == b->ends.leave_part;
}

static bool same_bits(const answer *a, const answer *b)
{
    return a->status == b->status && a->hit.part == b->hit.part &&
           memcmp(&a->hit.t, &b->hit.t, sizeof(double)) == 0 &&
           memcmp(&a->hit.t_error, &b->hit.t_error, sizeof(double)) == 0 &&
           memcmp(&a->normal, &b->normal, sizeof a->normal) == 0 && a->chord == b->chord &&
           memcmp(&a->ends.t_enter, &b->ends.t_enter, sizeof(double)) == 0 &&
           memcmp(&a->ends.t_leave, &b->ends.t_leave, sizeof(double)) == 0 && same_parts(a, b);
}

/* Certain's t differs between environments, and so its error; what exact says of it holds. */
static bool agree(const answer *certain, const answer *exact)
{
    double slack = certain->hit.t_error + exact->hit.t_error;
    if (certain->status != exact->status || certain->chord != exact->chord ||
        !same_parts(certain, exact))
        return false;
    if (certain->status != SURE_HIT)
        return memcmp(&certain->hit, &exact->hit, sizeof certain->hit) == 0;
    return certain->hit.part == exact->hit.part && certain->hit.t_error >= 0 &&
           (slack == INFINITY || fabs(certain->hit.t - exact->hit.t) <= slack);
}

/* Asked twice, the second time in an environment that the library has to undo. */
static void check_again(const sure_case *question, int environment)
{
    answer exact = ask(question, SURE_TIER_EXACT, 0);
    answer again = ask(question, SURE_TIER_EXACT, environment);
    answer certain = ask(question, SURE_TIER_CERTAIN, environment);
    if (!same_bits(&exact, &again))
        find(question, environment == 0 ? "exact: not the same answer twice"
                                        : "exact: not the same answer in another environment");
    if (!agree(&certain, &exact))
        find(question, "certain: not exact's answer in another environment");
}

#ifndef FUZZ_WITHOUT_REFERENCE
/* All that the campaign asks of a case, against the reference. */
static void check_promises(const sure_case *question, const choice *which)
{
    static pair_tally unused;
    campaign_check(question, which->more, find, &unused);
}
#else
/* Against one another: laws 5 and 8. */
static void check_promises(const sure_case *question, const choice *which)
{
    (void)which;
    check_laws(question, SURE_TIER_CERTAIN);
}
#endif

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    sure_shape shape;
    sure_case question;
    if (!sure_shape_from_name(fuzz_name, &shape))
        abort();
    if (!fuzz_case(&bytes, shape, &question))
        return false;
    choice which = draw_choice(fuzz_draws(data, size), fuzz_cost(&question));
    check_promises(&question, &which);
    if (which.laws < SURE_TIERS)
        check_laws(&question, which.laws);
    if (which.again)
        check_again(&question, which.environment);
    return true;
}

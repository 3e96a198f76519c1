/* SPDX-License-Identifier: MIT */
/* One ray and one shape, FUZZ_SHAPE: everything that the contract promises of hit, interval,
 * occluded and normal of every tier, and of the forms in floats of the ray and shape next to them.
 */

#include "answers.h"
#include "campaign_check.h"
#include "shape_bytes.h"
#include "shape_laws.h"
#include "surroundings.h"

FUZZ_TARGET(FUZZ_SHAPE, fuzz_mutate_doubles)

static void find(const sure_case *question, const char *law)
{
    fuzz_find(law, case_text(question));
}

/* Some of the checks cost more than all others together: see fuzz_draws. */
typedef struct {
    campaign_more more;
    bool again, floats;
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
    c.floats = fuzz_drawn(&draws, 8);
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

static answers ask(const sure_case *question, sure_tier tier, int environment)
{
    surroundings_set(environment);
    answers a = answers_of(question, tier, NULL);
    surroundings_set(0);
    return a;
}

/* Certain's t differs between environments, and so its error; what exact says of it holds. */
static bool agree(const answers *certain, const answers *exact)
{
    double slack = certain->hit.t_error + exact->hit.t_error;
    return answers_same_decisions(certain, exact) && certain->hit.t_error >= 0 &&
           (slack == INFINITY || fabs(certain->hit.t - exact->hit.t) <= slack);
}

/* Asked twice, the second time in an environment that the library has to undo. */
static void check_again(const sure_case *question, int environment)
{
    answers exact = ask(question, SURE_TIER_EXACT, 0);
    answers again = ask(question, SURE_TIER_EXACT, environment);
    answers certain = ask(question, SURE_TIER_CERTAIN, environment);
    if (memcmp(&exact, &again, sizeof exact) != 0)
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
    campaign_check(&truth_by_reference, question, which->more, find, &unused);
}
#else
/* Against one another: laws 5 and 8. */
static void check_promises(const sure_case *question, const choice *which)
{
    (void)which;
    check_laws(question, SURE_TIER_CERTAIN);
}
#endif

/* Alone and in a block. */
static void check_floats(const sure_case *question)
{
    static pair_tally unused;
    const campaign_more more = {.normal = true};
    campaign_check(&truth_of_floats, question, more, find, &unused);
}

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
    if (which.floats)
        check_floats(&question);
    return true;
}

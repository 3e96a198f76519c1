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

/* Without holes; 0 where nothing is. */
typedef struct {
    int decisions[6]; /* of hit and interval: status and parts; does the ray leave? */
    double t, t_error, t_enter, t_leave;
    sure_vec3 normal;
} answer;

static answer ask(const sure_case *question, sure_tier tier, int environment)
{
    const sure_ray *ray = &question->ray;
    const sure_object *object = &question->object;
    answer a = {.t = 0};
    sure_hit hit;
    sure_interval ends;
    surroundings_set(environment);
    a.decisions[0] = (int)sure_object_hit(ray, object, tier, &hit);
    a.decisions[1] = (int)sure_object_interval(ray, object, tier, &ends);
    if (a.decisions[0] == SURE_HIT) {
        a.normal = sure_object_normal(ray, object, tier, &hit);
        a.decisions[2] = (int)hit.part;
        a.decisions[3] = hit.leaves;
        a.t = hit.t;
        a.t_error = hit.t_error;
    }
    if (a.decisions[1] == SURE_HIT) {
        a.decisions[4] = (int)ends.enter_part;
        a.decisions[5] = (int)ends.leave_part;
        a.t_enter = ends.t_enter;
        a.t_leave = ends.t_leave;
    }
    surroundings_set(0);
    return a;
}

/* Certain's t differs between environments, and so its error; what exact says of it holds. */
static bool agree(const answer *certain, const answer *exact)
{
    double slack = certain->t_error + exact->t_error;
    return memcmp(certain->decisions, exact->decisions, sizeof exact->decisions) == 0 &&
           certain->t_error >= 0 && (slack == INFINITY || fabs(certain->t - exact->t) <= slack);
}

/* Asked twice, the second time in an environment that the library has to undo. */
static void check_again(const sure_case *question, int environment)
{
    answer exact = ask(question, SURE_TIER_EXACT, 0);
    answer again = ask(question, SURE_TIER_EXACT, environment);
    answer certain = ask(question, SURE_TIER_CERTAIN, environment);
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

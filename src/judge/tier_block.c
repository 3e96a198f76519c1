#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "tier_block.h"

#include "cpu_time.h"

/* No branch here depends on the answer: the routine's own are to be timed, and a routine that has
 * none would pay for ours. */
static void ask_hits(sure_tier tier, const sure_case *cases, int count, bool backwards,
                     tier_answer *answers)
{
    for (int n = 0; n < count; n++) {
        int i = backwards ? count - 1 - n : n;
        answers[i].status = sure_object_hit(&cases[i].ray, &cases[i].object, tier, &answers[i].hit);
    }
}

static void ask_with_normals(sure_tier tier, const sure_case *cases, int count, bool backwards,
                             tier_answer *answers)
{
    for (int n = 0; n < count; n++) {
        int i = backwards ? count - 1 - n : n;
        const sure_case *c = &cases[i];
        tier_answer *to = &answers[i];
        to->status = sure_object_hit(&c->ray, &c->object, tier, &to->hit);
        if (to->status == SURE_HIT)
            to->normal = sure_object_normal(&c->ray, &c->object, tier, &to->hit);
    }
}

double tier_block_ask(sure_tier tier, const sure_case *cases, int count, bool normals,
                      bool backwards, tier_answer *answers)
{
    double start = cpu_time();
    if (normals)
        ask_with_normals(tier, cases, count, backwards, answers);
    else
        ask_hits(tier, cases, count, backwards, answers);
    return cpu_time() - start;
}

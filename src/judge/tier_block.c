#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "tier_block.h"

#include "cpu_time.h"

double tier_block_ask(sure_tier tier, const sure_case *cases, int count, bool normals,
                      bool backwards, tier_answer *answers)
{
    double start = cpu_time();
    for (int n = 0; n < count; n++) {
        int i = backwards ? count - 1 - n : n;
        const sure_case *c = &cases[i];
        tier_answer *to = &answers[i];
        to->status = sure_object_hit(&c->ray, &c->object, tier, &to->hit);
        if (normals && to->status == SURE_HIT)
            to->normal = sure_object_normal(&c->ray, &c->object, tier, &to->hit);
    }
    return cpu_time() - start;
}

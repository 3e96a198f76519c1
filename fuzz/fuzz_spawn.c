/* SPDX-License-Identifier: MIT */
/* Where a ray that leaves a surface begins: on the right side, next to the hit point, none only
 * where there is none, and the same in every environment. */

#include "../tests/stages/spawned.h"
#include "shape_bytes.h"
#include "tiers.h"
#ifndef FUZZ_WITHOUT_REFERENCE
#include "reference.h"
#include "spawn_truth.h"
#include "test_shape.h"
#include "true_hit.h"
#endif

FUZZ_TARGET("spawn", fuzz_mutate_doubles)

#ifndef FUZZ_WITHOUT_REFERENCE
static bool is_near(sure_vec3 origin, sure_vec3 p)
{
    return reference_ulps(origin.x, p.x) <= SURE_SPAWN_STEPS &&
           reference_ulps(origin.y, p.y) <= SURE_SPAWN_STEPS &&
           reference_ulps(origin.z, p.z) <= SURE_SPAWN_STEPS;
}

/* So far from o + t d, as doubles have it, that a look at the true point may be worth its time. */
static bool seems_far(const sure_case *question, const sure_hit *hit, sure_vec3 origin)
{
    sure_vec3 p = vector_sum(1, question->ray.origin, hit->t, question->ray.direction);
    return all_finite(p) && !is_near(origin, p);
}

/* The true hit point costs a hundred times as much as all the rest, a search of the box more. */
static void check_truth(const sure_case *question, sure_side side, const sure_hit *hit,
                        const spawned *s, uint64_t *draws)
{
    bool point = fuzz_drawn(draws, 512), search = fuzz_drawn(draws, 512);
    bool far = fuzz_drawn(draws, 64) && s->found && seems_far(question, hit, s->origin);
    sure_object sided = object_sided(&question->object);
    double t, p[3];
    expect(!s->found || spawn_is_on_side(&sided, s->origin, side), "Law 1: not on that side");
    if (!point && !far && !(search && !s->found))
        return;
    expect(true_point(question, &t, p), "there is no hit");
    expect(s->found ? is_near(s->origin, (sure_vec3){p[0], p[1], p[2]})
                    : spawn_may_have_none(&question->object, p, side),
           "Law 2: not next to the hit");
    expect(s->found || !search || !spawn_box_has(&sided, p, side), "Law 2: there is one");
}
#endif

static void check_again(const sure_case *question, sure_side side, const spawned *first,
                        int environment)
{
    sure_hit hit;
    surroundings_set(environment);
    sure_object_hit(&question->ray, &question->object, SURE_TIER_CERTAIN, &hit);
    surroundings_set(0);
    spawned s = spawn_in(question, &hit, (int)side, environment);
    expect(same_spawned(&s, first), "not the same in another environment");
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    uint8_t how = fuzz_byte(&bytes);
    uint64_t draws = fuzz_draws(data, size);
    sure_case question;
    sure_hit hit;
    if (!fuzz_case(&bytes, (sure_shape)(how / 4 % SURE_SHAPES), &question))
        return false;
    fuzz_cheapen(&question, &draws);
    sure_side side = how & 1 ? SURE_SIDE_INSIDE : SURE_SIDE_OUTSIDE;
    sure_tier tier = how & 2 ? SURE_TIER_EXACT : SURE_TIER_CERTAIN;
    if (!fuzz_hit(&question, tier, &hit))
        return false;
    spawned s = spawn_in(&question, &hit, (int)side, 0), none = {0, untouched};
    fuzz_ask("%s", text(&question, (int)side));
    expect(s.found == 1 || same_spawned(&s, &none), "neither 1, nor 0 and untouched");
    expect(!s.found || all_finite(s.origin), "not finite");
#ifndef FUZZ_WITHOUT_REFERENCE
    check_truth(&question, side, &hit, &s, &draws);
#endif
    if (fuzz_drawn(&draws, 4))
        check_again(&question, side, &s, (int)(draws % SURROUNDINGS));
    return true;
}

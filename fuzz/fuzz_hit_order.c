/* SPDX-License-Identifier: MIT */
/* One ray's hits on two objects: which comes first? Against the order of the real numbers. */

#include "shape_bytes.h"
#include "surroundings.h"
#ifndef FUZZ_WITHOUT_REFERENCE
#include "reference.h"
#endif

#include <surehit/hit_order.h>

FUZZ_TARGET("hit_order", fuzz_mutate_doubles)

typedef struct {
    sure_case question;
    sure_object other;
    sure_hit first, second; /* of the tiers that the bytes choose */
    double t, u;            /* by exact */
} pair;

static int order(const pair *p)
{
    return sure_hit_order(&p->question.ray, &p->question.object, &p->first, &p->other, &p->second);
}

/* In the exact tier t, in the other its hit. */
static bool hit_by(const sure_ray *ray, const sure_object *object, bool certain, sure_hit *hit,
                   double *t)
{
    if (sure_object_hit(ray, object, SURE_TIER_EXACT, hit) != SURE_HIT)
        return false;
    *t = hit->t;
    if (certain)
        sure_object_hit(ray, object, SURE_TIER_CERTAIN, hit);
    return true;
}

/* The other that the bytes make; where it is not hit, a plane across the ray at the hit. */
static bool read_other(fuzz_bytes *bytes, bool certain, pair *p)
{
    const sure_ray *ray = &p->question.ray;
    if (fuzz_other_object(bytes, &p->question, p->t, &p->other) &&
        hit_by(ray, &p->other, certain, &p->second, &p->u))
        return true;
    p->other = fuzz_plane_across(ray, p->t);
    return hit_by(ray, &p->other, certain, &p->second, &p->u);
}

static bool read_pair(fuzz_bytes *bytes, uint8_t how, uint64_t draws, pair *p)
{
    sure_shape shape = (sure_shape)(how / 16 % SURE_SHAPES);
    if (!fuzz_case(bytes, shape, &p->question))
        return false;
    fuzz_cheapen(&p->question, &draws);
    return fuzz_hit(&p->question, SURE_TIER_EXACT, &p->first) &&
           hit_by(&p->question.ray, &p->question.object, how & 1, &p->first, &p->t) &&
           read_other(bytes, how & 2, p);
}

static void check_truth(const pair *p, int given)
{
#ifndef FUZZ_WITHOUT_REFERENCE
    int truth = 2;
    expect(reference_hit_order(&p->question.ray, &p->question.object, &p->other, &truth) ==
               SURE_HIT,
           "the reference sees no hit");
    expect(given == truth, "not the order of the real numbers");
#else
    (void)p, (void)given;
#endif
}

/* The object against itself, by hits of any tier: a tie. */
static bool ties_with_itself(const pair *p)
{
    const sure_ray *ray = &p->question.ray;
    const sure_object *object = &p->question.object;
    sure_hit exact;
    double t;
    return hit_by(ray, object, false, &exact, &t) &&
           sure_hit_order(ray, object, &p->first, object, &exact) == 0;
}

static void check_pair(const pair *p, int environment)
{
    char line[CASE_LINE_MAX];
    sure_case second = {.ray = p->question.ray, .object = p->other};
    int given = order(p);
    case_print(&p->question, line);
    fuzz_ask("%s\n%s", line, case_text(&second));
    check_truth(p, given);
    int back =
        sure_hit_order(&p->question.ray, &p->other, &p->second, &p->question.object, &p->first);
    expect(back == -given, "Law 1: exchanging the two changes the sign");
    expect(ties_with_itself(p), "Law 2: an object ties with itself");
    expect(p->t < p->u ? given < 0 : p->t == p->u || given > 0,
           "Law 3: t of exact is in the same order or equal");
    pair there = *p;
    surroundings_set(environment);
    int again = order(p);
    sure_object_hit(&p->question.ray, &p->question.object, SURE_TIER_CERTAIN, &there.first);
    sure_object_hit(&p->question.ray, &p->other, SURE_TIER_CERTAIN, &there.second);
    int of_its_hits = order(&there);
    surroundings_set(0);
    expect(again == given && of_its_hits == given, "not the same in another environment");
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    uint8_t how = fuzz_byte(&bytes), environment = fuzz_byte(&bytes) % SURROUNDINGS;
    pair p;
    if (!read_pair(&bytes, how, fuzz_draws(data, size), &p))
        return false;
    check_pair(&p, environment);
    return true;
}

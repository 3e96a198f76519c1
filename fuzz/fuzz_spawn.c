/* Where a ray that leaves a surface begins: on the right side, next to the hit point, none only
 * where there is none, and the same in every environment. */
#include "fuzz.h"

#include "shape_bytes.h"
#include "surroundings.h"
#ifndef FUZZ_WITHOUT_REFERENCE
#include "reference.h"
#include "spawn_truth.h"
#include "test_shape.h"
#include "true_hit.h"
#endif

#include <math.h>
#include <string.h>

#include <surehit/bounds.h>
#include <surehit/spawn.h>

const char fuzz_name[] = "spawn";
size_t (*const fuzz_mutator)(uint8_t *, size_t, size_t, unsigned) = fuzz_mutate_doubles;

typedef struct {
    int found;
    sure_vec3 origin;
} spawned;

static const sure_vec3 untouched = {0x1.5p500, -0x1.5p500, 0x1.7p500};

static bool same_vector(const sure_vec3 *v, const sure_vec3 *w)
{
    return memcmp(v, w, sizeof *v) == 0;
}

static void find(const sure_case *question, sure_side side, const char *outside, const char *inside)
{
    fuzz_find(side == SURE_SIDE_OUTSIDE ? outside : inside, fuzz_case_text(question));
}

static spawned spawn(const sure_case *question, const sure_hit *hit, sure_side side)
{
    spawned s = {.origin = untouched};
    s.found = sure_spawn(&question->ray, &question->object, hit, side, &s.origin);
    return s;
}

/* The true hit point costs a hundred times as much as all the rest, a search of the box more. */
typedef struct {
    bool point, search;
    bool far; /* of a point that seems far */
} choice;

static choice draw_choice(uint64_t *draws)
{
    choice c;
    c.point = fuzz_drawn(draws, 512);
    c.search = fuzz_drawn(draws, 512);
    c.far = fuzz_drawn(draws, 64);
    return c;
}

#ifndef FUZZ_WITHOUT_REFERENCE
/* So far from o + t d, as doubles have it, that a look at the true point may be worth its time. */
static bool seems_far(const sure_case *question, const sure_hit *hit, const sure_vec3 *origin)
{
    const sure_vec3 *o = &question->ray.origin, *d = &question->ray.direction;
    sure_vec3 p = {o->x + hit->t * d->x, o->y + hit->t * d->y, o->z + hit->t * d->z};
    return isfinite(p.x) && isfinite(p.y) && isfinite(p.z) &&
           (reference_ulps(origin->x, p.x) > SURE_SPAWN_STEPS ||
            reference_ulps(origin->y, p.y) > SURE_SPAWN_STEPS ||
            reference_ulps(origin->z, p.z) > SURE_SPAWN_STEPS);
}

static bool is_near(const sure_vec3 *origin, const double p[3])
{
    return reference_ulps(origin->x, p[0]) <= SURE_SPAWN_STEPS &&
           reference_ulps(origin->y, p[1]) <= SURE_SPAWN_STEPS &&
           reference_ulps(origin->z, p[2]) <= SURE_SPAWN_STEPS;
}

static void check_truth(const sure_case *question, sure_side side, const sure_hit *hit,
                        const spawned *s, choice which)
{
    sure_object sided = object_sided(&question->object);
    double t, p[3];
    if (s->found && !spawn_is_on_side(&sided, s->origin, side))
        find(question, side, "Law 1: not outside", "Law 1: not inside");
    bool far = which.far && s->found && seems_far(question, hit, &s->origin);
    if (!which.point && !far && !(which.search && !s->found))
        return;
    if (!true_point(question, &t, p))
        find(question, side, "there is no hit", "there is no hit");
    if (s->found ? !is_near(&s->origin, p) : !spawn_may_have_none(&question->object, p, side))
        find(question, side, "Law 2: not next to the hit, outside",
             "Law 2: not next to the hit, inside");
    if (!s->found && which.search && spawn_box_has(&sided, p, side))
        find(question, side, "Law 2: there is an outside", "Law 2: there is an inside");
}
#else
static void check_truth(const sure_case *question, sure_side side, const sure_hit *hit,
                        const spawned *s, choice which)
{
    (void)hit, (void)which;
    if (s->found && !(isfinite(s->origin.x) && isfinite(s->origin.y) && isfinite(s->origin.z)))
        find(question, side, "not finite, outside", "not finite, inside");
}
#endif

static void check_again(const sure_case *question, sure_side side, const spawned *first,
                        int environment)
{
    sure_hit hit;
    surroundings_set(environment);
    sure_object_hit(&question->ray, &question->object, SURE_TIER_CERTAIN, &hit);
    spawned s = spawn(question, &hit, side);
    surroundings_set(0);
    if (s.found != first->found || !same_vector(&s.origin, &first->origin))
        find(question, side, "not the same in another environment, outside",
             "not the same in another environment, inside");
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
    spawned s = spawn(&question, &hit, side);
    if (s.found == 0 ? !same_vector(&s.origin, &untouched) : s.found != 1)
        find(&question, side, "outside: 1, or 0 and untouched", "inside: 1, or 0 and untouched");
    check_truth(&question, side, &hit, &s, draw_choice(&draws));
    if (fuzz_drawn(&draws, 4))
        check_again(&question, side, &s, (int)(draws % SURROUNDINGS));
    return true;
}

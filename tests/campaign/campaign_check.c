/* SPDX-License-Identifier: MIT */
#include "campaign_check.h"

#include "campaign_block.h"

#include "../../src/cases/case_floats.h"
#include "../support/long_vector.h"
#include "../support/test_shape.h"

#include <surehit/bounds.h>
#include <surehit/spawn.h>

#include <stdio.h>

typedef struct {
    const campaign_truth *by;
    const sure_case *question;
    tally_truth truth;
    double proven_error; /* at t = truth.t; infinite at first */
    campaign_report *report;
    pair_tally *sum;
} trial;

static const sure_tier promising[] = {SURE_TIER_CERTAIN, SURE_TIER_EXACT};
enum { PROMISING = sizeof promising / sizeof *promising };

static void broken(const trial *x, sure_tier tier, const char *what)
{
    char line[128];
    snprintf(line, sizeof line, "%s: %s", sure_tier_name(tier), what);
    x->sum->broken++;
    x->report(x->question, line);
}

static void expect(const trial *x, sure_tier tier, bool holds, const char *what)
{
    if (!holds)
        broken(x, tier, what);
}

/* Certainly t_error |d| <= SURE_T_ERROR_CAP (|o - object| + size). */
static bool within_cap(const sure_case *question, long double error)
{
    long double travelled = error * long_length(long_of(question->ray.direction));
    return travelled * (1 + LONG_SLACK) <=
           SURE_T_ERROR_CAP * object_reach(question->ray.origin, &question->object);
}

/* To the neighbour away from zero. A correctly rounded number is off by half of it at most. */
static double step_at(double t)
{
    return nextafter(t, INFINITY) - t;
}

/* At most this far from the real number that `rounded` is rounded from, itself rounded upwards. */
static double distance_above(double t, double rounded)
{
    double apart = nextafter(fabs(t - rounded), INFINITY);
    return nextafter(apart + step_at(rounded), INFINITY);
}

/* |t - t*| <= error: from the correctly rounded t where that tells, and else by the reference. */
static bool is_within(trial *x, double t, double error)
{
    double rounded = x->truth.t;
    if (isinf(rounded))
        return t == rounded && isinf(error);
    if (distance_above(t, rounded) <= error)
        return true;
    bool same = t == rounded;
    if (same && (2 * error >= step_at(t) || error >= x->proven_error))
        return true;
    bool within = x->by->hit_within(&x->question->ray, &x->question->object, t, error);
    if (same && within)
        x->proven_error = error;
    return within;
}

static bool same_bits(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

static void check_t(trial *x, sure_tier tier, const sure_hit *hit)
{
    const sure_ray *ray = &x->question->ray;
    expect(x, tier, hit->t >= ray->t_min && hit->t <= ray->t_max, "t is out of the range");
    expect(x, tier, hit->t_error >= 0 && is_within(x, hit->t, hit->t_error), "t_error");
    if (tier == SURE_TIER_EXACT) {
        expect(x, tier, same_bits(&hit->t, &x->truth.t, sizeof hit->t), "t");
    } else if (!within_cap(x->question, hit->t_error)) {
        x->sum->out_of_cap++;
        double half = isinf(hit->t) ? INFINITY : fmax(step_at(hit->t) / 2, 0x1p-1074);
        expect(x, tier, hit->t_error <= half && hit->t == x->truth.t,
               "t_error is above its cap, and t is not the nearest double");
    }
}

static bool is_normal_within(const trial *x, const sure_vec3 *normal, const sure_vec3 *rounded)
{
    if (distance_above(normal->x, rounded->x) <= SURE_NORMAL_ERROR &&
        distance_above(normal->y, rounded->y) <= SURE_NORMAL_ERROR &&
        distance_above(normal->z, rounded->z) <= SURE_NORMAL_ERROR)
        return true;
    return x->by->normal_within(&x->question->ray, &x->question->object, *normal,
                                SURE_NORMAL_ERROR);
}

static void check_normal(const trial *x, sure_tier tier, const sure_hit *hit,
                         const sure_vec3 *rounded)
{
    sure_vec3 normal = sure_object_normal(&x->question->ray, &x->question->object, tier, hit);
    if (tier == SURE_TIER_EXACT)
        expect(x, tier, same_bits(&normal, rounded, sizeof normal), "normal");
    else
        expect(x, tier, is_normal_within(x, &normal, rounded), "normal's bound");
}

static bool is_end_within_cap(const trial *x, double t, double rounded)
{
    if (t == rounded)
        return true;
    return isfinite(rounded) &&
           within_cap(x->question, fabsl((long double)t - rounded) + step_at(fabs(rounded)));
}

static void check_ends(const trial *x, sure_tier tier, const sure_interval *given,
                       const sure_interval *truth)
{
    expect(x, tier, given->enter_part == truth->enter_part, "part of the interval's enter");
    expect(x, tier, given->leave_part == truth->leave_part, "part of the interval's leave");
    expect(x, tier, given->t_enter <= given->t_leave, "the interval's order");
    if (tier == SURE_TIER_EXACT) {
        expect(x, tier, same_bits(&given->t_enter, &truth->t_enter, sizeof(double)), "t_enter");
        expect(x, tier, same_bits(&given->t_leave, &truth->t_leave, sizeof(double)), "t_leave");
    } else {
        expect(x, tier, is_end_within_cap(x, given->t_enter, truth->t_enter), "t_enter's cap");
        expect(x, tier, is_end_within_cap(x, given->t_leave, truth->t_leave), "t_leave's cap");
    }
}

static void check_interval(const trial *x)
{
    const sure_ray *ray = &x->question->ray;
    const sure_object *object = &x->question->object;
    sure_interval truth;
    sure_status status = x->by->interval(ray, object, &truth);
    x->sum->intervals++;
    for (int i = 0; i < PROMISING; i++) {
        sure_interval untouched, given;
        memset(&untouched, 0xa5, sizeof untouched);
        given = untouched;
        sure_tier tier = promising[i];
        sure_status answer = sure_object_interval(ray, object, tier, &given);
        expect(x, tier, answer == status, "the interval's status");
        if (status == SURE_HIT)
            check_ends(x, tier, &given, &truth);
        else
            expect(x, tier, same_bits(&given, &untouched, sizeof given), "interval touched");
    }
}

static void check_occluded(const trial *x)
{
    for (int i = 0; i < PROMISING; i++) {
        sure_status status =
            sure_object_occluded(&x->question->ray, &x->question->object, promising[i]);
        expect(x, promising[i], status == x->truth.status, "occluded");
    }
}

/* Can the double be SURE_SPAWN_STEPS from that nearest to o + t* d? Only what is certainly farther
 * is refused: t* is counted half an ulp off, and o + t d is in long double. */
static bool may_be_next_to(double origin, double o, double d, double t)
{
    long double way = (long double)t * d, point = o + way;
    double most = fmax(fabs(origin), (double)fabsl(point));
    if (!isfinite(most) || !isfinite(step_at(most)) || !isfinite(step_at(t)))
        return true;
    long double slack = (long double)step_at(t) * fabs(d) + (fabsl(o) + fabsl(way)) * LONG_SLACK;
    return fabsl(origin - point) <= slack + (SURE_SPAWN_STEPS + 1) * (long double)step_at(most);
}

/* Is there an origin on that side? It has to be strictly there, and next to the hit. */
static bool has_origin(const trial *x, const sure_hit *hit, sure_side side)
{
    const sure_ray *ray = &x->question->ray;
    sure_object sided = object_sided(&x->question->object);
    sure_vec3 origin, o = ray->origin, d = ray->direction;
    double t = x->truth.t;
    if (!sure_spawn(ray, &x->question->object, hit, side, &origin))
        return false;
    expect(x, SURE_TIER_CERTAIN,
           x->by->where(&sided, origin) == (side == SURE_SIDE_OUTSIDE ? 1 : -1), "spawn's side");
    expect(x, SURE_TIER_CERTAIN,
           may_be_next_to(origin.x, o.x, d.x, t) && may_be_next_to(origin.y, o.y, d.y, t) &&
               may_be_next_to(origin.z, o.z, d.z, t),
           "spawn's distance");
    return true;
}

static void check_spawn(const trial *x)
{
    sure_hit hit;
    if (sure_object_hit(&x->question->ray, &x->question->object, SURE_TIER_CERTAIN, &hit) !=
        SURE_HIT)
        return;
    x->sum->spawns++;
    x->sum->no_outside += !has_origin(x, &hit, SURE_SIDE_OUTSIDE);
    x->sum->no_inside += !has_origin(x, &hit, SURE_SIDE_INSIDE);
}

static void check_parts(const trial *x, uint64_t draw)
{
    const char *broken_parts[CAMPAIGN_PARTS] = {NULL};
    x->by->parts(x->question, draw, broken_parts);
    for (int i = 0; i < CAMPAIGN_PARTS; i++) {
        if (broken_parts[i])
            broken(x, SURE_TIER_CERTAIN, broken_parts[i]);
    }
}

static void check_bracket(const trial *x)
{
    const char *broken_law = x->by->bracket(x->question);
    if (broken_law)
        broken(x, SURE_TIER_EXACT, broken_law);
}

/* Where the first stage decides, and where it is wanted. */
static void check_block(trial *x, bool wanted, sure_status status, const sure_hit *hit)
{
    const sure_case *q = x->question;
    if (wanted || sure_object_stage(&q->ray, &q->object, SURE_TIER_CERTAIN) == SURE_STAGE_DOUBLE)
        expect(x, SURE_TIER_CERTAIN, is_same_in_a_block(q, status, hit), "a block");
}

static void ask_tier(trial *x, sure_tier tier, const sure_vec3 *normal, bool block)
{
    const sure_ray *ray = &x->question->ray;
    const sure_object *object = &x->question->object;
    tier_tally *counts = &x->sum->tiers[tier];
    sure_hit untouched, hit;
    memset(&untouched, 0xa5, sizeof untouched);
    memcpy(&hit, &untouched, sizeof hit);
    sure_status status = sure_object_hit(ray, object, tier, &hit);
    bool right = tally_hit(counts, tier, &x->truth, status, &hit);
    if (tier < SURE_TIER_CERTAIN) {
        bool invalid = x->truth.status == SURE_INVALID;
        expect(x, tier, (status == SURE_INVALID) == invalid, "validity");
        return;
    }
    counts->stages[sure_object_stage(ray, object, tier)]++;
    if (tier == SURE_TIER_CERTAIN)
        check_block(x, block, status, &hit);
    if (!right) {
        broken(x, tier, "status or part");
    } else if (status != SURE_HIT) {
        expect(x, tier, same_bits(&hit, &untouched, sizeof hit), "hit touched");
    } else {
        check_t(x, tier, &hit);
        if (normal)
            check_normal(x, tier, &hit, normal);
    }
}

/* The finalizer of SplitMix64 (Steele, Lea, Flood 2014): what is checked of a case must not go
 * with what a regime makes of its index. */
static uint64_t draw_of(uint64_t index)
{
    uint64_t x = index + UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ x >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ x >> 27) * UINT64_C(0x94d049bb133111eb);
    return x ^ x >> 31;
}

/* A quarter of the hits' normals, a sixteenth each of blocks that the first stage leaves, of the
 * intervals, of occluded and of the hits' spawns, and fewer of the solids' parts and of the hits'
 * brackets, which take long. */
campaign_more campaign_more_of(uint64_t index)
{
    uint64_t draw = draw_of(index);
    return (campaign_more){.normal = draw % 4 == 0,
                           .block = draw / 4294967296 % 16 == 0,
                           .interval = draw / 4 % 16 == 0,
                           .occluded = draw / 64 % 16 == 0,
                           .spawn = draw / 1024 % 16 == 0,
                           .bracket = draw / 1048576 % 4096 == 0,
                           .parts = draw / 16384 % 64 == 0 ? draw_of(draw) | 1 : 0};
}

/* In floats. */

/* Does every number that rounds to the double x round to this float? */
static bool is_no_tie(double x)
{
    return (float)nextafter(x, -INFINITY) == (float)nextafter(x, INFINITY);
}

/* The float next to the number that the double is next to; of a tie either. */
static bool is_next_float(float given, double rounded)
{
    const float beyond = nextafterf(given, rounded > given ? INFINITY : -INFINITY);
    return is_no_tie(rounded)
               ? same_bits(&given, &(float){(float)rounded + 0.0F}, sizeof given)
               : fabsl((long double)given - rounded) <= fabsl((long double)beyond - given) / 2;
}

static bool is_next_vector(const sure_float_vec3 *given, const sure_vec3 *rounded)
{
    return is_next_float(given->x, rounded->x) && is_next_float(given->y, rounded->y) &&
           is_next_float(given->z, rounded->z);
}

static bool is_float_normal_within(const sure_float_vec3 *given, const sure_vec3 *rounded)
{
    const double most = SURE_FLOAT_NORMAL_ERROR + 0x1p-53;
    return fabs(given->x - rounded->x) <= most && fabs(given->y - rounded->y) <= most &&
           fabs(given->z - rounded->z) <= most;
}

static void ask_floats(trial *x, const float_query *q, sure_tier tier, const sure_vec3 *normal)
{
    sure_hit_f untouched, hit;
    memset(&untouched, 0xa5, sizeof untouched);
    memcpy(&hit, &untouched, sizeof hit);
    const sure_status status = float_query_hit(q, tier, &hit);
    const sure_hit wide = {.t = hit.t, .part = hit.part};
    tally_truth seen = x->truth;
    seen.t = (float)seen.t;
    if (!tally_hit(&x->sum->tiers[tier], tier, &seen, status, &wide)) {
        broken(x, tier, "status or part in floats");
        return;
    }
    if (tier == SURE_TIER_CERTAIN)
        expect(x, tier, is_same_in_a_block_of_floats(q, status, &hit), "a block of floats");
    if (status != SURE_HIT) {
        expect(x, tier, same_bits(&hit, &untouched, sizeof hit), "hit touched in floats");
        return;
    }
    expect(x, tier, is_next_float(hit.t, x->truth.t), "t in floats");
    if (!normal)
        return;
    const sure_float_vec3 given = float_query_normal(q, tier, &hit);
    expect(x, tier,
           tier == SURE_TIER_EXACT ? is_next_vector(&given, normal)
                                   : is_float_normal_within(&given, normal),
           "normal in floats");
}

/* What floats can't say is no case, but counted as one that is invalid. */
static void check_floats(trial *x, bool with_normal)
{
    sure_case rounded;
    sure_vec3 normal;
    if (!float_case(x->question, &rounded)) {
        tally_truth_seen(x->sum, SURE_INVALID);
        return;
    }
    x->question = &rounded;
    x->truth.status = x->by->hit(&rounded.ray, &rounded.object, &x->truth.t, &x->truth.part,
                                 with_normal ? &normal : NULL);
    tally_truth_seen(x->sum, x->truth.status);
    with_normal = with_normal && x->truth.status == SURE_HIT;
    x->sum->normals += with_normal;
    const float_query q = float_query_of(&rounded);
    expect(x, SURE_TIER_EXACT, float_query_check(&q) == x->by->check(&rounded.ray, &rounded.object),
           "check's field in floats");
    for (int i = 0; i < PROMISING; i++)
        ask_floats(x, &q, promising[i], with_normal ? &normal : NULL);
}

void campaign_check(const campaign_truth *by, const sure_case *question, campaign_more more,
                    campaign_report *report, pair_tally *sum)
{
    trial x = {by, question, .proven_error = INFINITY, .report = report, .sum = sum};
    bool with_normal = more.normal;
    sure_vec3 normal;
    if (by->floats) {
        check_floats(&x, with_normal);
        return;
    }
    x.truth.status = by->hit(&question->ray, &question->object, &x.truth.t, &x.truth.part,
                             with_normal ? &normal : NULL);
    tally_truth_seen(sum, x.truth.status);
    bool hit = x.truth.status == SURE_HIT;
    with_normal = with_normal && hit;
    sum->normals += with_normal;
    expect(&x, SURE_TIER_EXACT,
           sure_object_check(&question->ray, &question->object) ==
               by->check(&question->ray, &question->object),
           "check's field");
    for (sure_tier tier = by->first; tier < SURE_TIERS; tier++)
        ask_tier(&x, tier, with_normal ? &normal : NULL, more.block);
    if (more.interval)
        check_interval(&x);
    if (more.occluded)
        check_occluded(&x);
    if (more.spawn && hit && by->where)
        check_spawn(&x);
    if (more.bracket && hit && by->bracket)
        check_bracket(&x);
    if (more.parts && x.truth.status != SURE_INVALID && by->parts)
        check_parts(&x, more.parts);
}

/* SPDX-License-Identifier: MIT */
#include "shape_laws.h"

#include "long_vector.h"
#include "moved_case.h"
#include "test_shape.h"

#include <fenv.h>

#include <surehit/bounds.h>

typedef struct {
    sure_status status;
    sure_hit hit;
    sure_vec3 normal;
    bool ranged; /* something over- or underflowed on the way */
    bool guess;  /* stable's, where the first stage is uncertain */
} outcome;

static bool is_guess(const sure_case *question, const outcome *stable)
{
    if (stable->status == SURE_HIT)
        return stable->hit.t_error == INFINITY;
    return sure_object_stage(&question->ray, &question->object, SURE_TIER_CERTAIN) !=
           SURE_STAGE_DOUBLE;
}

static outcome ask(const sure_case *question, sure_tier tier)
{
    outcome o = {0};
    fenv_t kept;
    feholdexcept(&kept);
    o.status = sure_object_hit(&question->ray, &question->object, tier, &o.hit);
    if (o.status == SURE_HIT)
        o.normal = sure_object_normal(&question->ray, &question->object, tier, &o.hit);
    o.ranged = fetestexcept(FE_OVERFLOW | FE_UNDERFLOW) != 0;
    fesetenv(&kept);
    o.guess = tier == SURE_TIER_STABLE && is_guess(question, &o);
    return o;
}

static bool is_sure(sure_tier tier)
{
    return tier >= SURE_TIER_CERTAIN;
}

static bool same_vector(sure_vec3 a, sure_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool near_vector(sure_vec3 a, sure_vec3 b, double most)
{
    return fabs(a.x - b.x) <= most && fabs(a.y - b.y) <= most && fabs(a.z - b.z) <= most;
}

/* Are both t within their errors of one number? Rounding is monotone: a computed difference is not
 * above a computed sum when it is not above it in truth. Nothing is said of t that overflowed. */
static bool meet(double t, double error, double other, double other_error)
{
    return error + other_error == INFINITY || fabs(t - other) <= error + other_error;
}

/* The same for t and other, which is of a question in which t* is 2^k times as large. The smaller
 * one is scaled up, which is exact; or both down where that overflows. */
static bool meet_scaled(const sure_hit *hit, const sure_hit *other, int k)
{
    int up = k > 0 ? k : 0, other_up = k < 0 ? -k : 0;
    if (isinf(ldexp(hit->t, up)) || isinf(ldexp(other->t, other_up))) {
        up -= 64;
        other_up -= 64;
    }
    return meet(ldexp(hit->t, up), ldexp(hit->t_error, up), ldexp(other->t, other_up),
                ldexp(other->t_error, other_up));
}

/* Is a number that was rounded to x in the range of full precision for certain? */
static bool is_normal(double x)
{
    return fabs(x) > 0x1p-1022 && fabs(x) <= 0x1.fffffffffffffp1023;
}

/* t and other are a number and 2^k times it, both correctly rounded. Where over- or underflow does
 * to one what it does not to the other, the one with more digits tells between which two the other
 * is: rounding is monotone. */
static bool same_rounded(double t, double other, int k)
{
    double scaled = ldexp(t, k);
    if (is_normal(t) && is_normal(scaled))
        return other == scaled;
    if (k > 0 && is_normal(other))
        return same_rounded(other, t, -k);
    return ldexp(nextafter(t, 0), k) <= other && other <= ldexp(nextafter(t, INFINITY), k);
}

/* Is `moved` the outcome `plain` with t times 2^k and the normal as expected? */
static bool same_outcome(sure_tier tier, const outcome *plain, const outcome *moved, int k,
                         sure_vec3 expected_normal)
{
    if (plain->status != moved->status)
        return false;
    if (plain->status != SURE_HIT)
        return true;
    if (plain->hit.part != moved->hit.part || plain->hit.leaves != moved->hit.leaves)
        return false;
    if (tier == SURE_TIER_CERTAIN || (tier == SURE_TIER_STABLE && !plain->guess))
        return meet_scaled(&plain->hit, &moved->hit, k) &&
               near_vector(moved->normal, expected_normal, 2 * SURE_NORMAL_ERROR);
    if (!same_vector(moved->normal, expected_normal))
        return false;
    return tier == SURE_TIER_EXACT ? same_rounded(plain->hit.t, moved->hit.t, k)
                                   : moved->hit.t == ldexp(plain->hit.t, k);
}

/* What over- or underflow does to an outcome is no fault of a plain tier; nor that its first stage
 * has a range. */
static bool is_void(sure_tier tier, const outcome *plain, const outcome *moved)
{
    return !is_sure(tier) && (plain->ranged || moved->ranged || plain->guess != moved->guess);
}

/* Law 1: scaling origin, object and t range by 2^k; the normal of a plane or disc is a length too,
 * and may be scaled or not. Law 2: d -> 2^k d with the t range 2^-k. */
static bool law_scale(const sure_case *question, sure_tier tier, const outcome *plain,
                      bool of_direction, unsigned long *checked)
{
    static const int powers[][2][4] = {{{-40, -3, 1, 17}, {-800, -3, 17, 700}},
                                       {{-30, 1, 8}, {-700, 1, 600}}};
    for (int i = 0; i < 4; i++) {
        int k = powers[of_direction][is_sure(tier)][i];
        const int lengths[NUMBER_KINDS] = {k, 0, k, k}, steps[NUMBER_KINDS] = {0, k, -k, 0};
        sure_case moved;
        if (k == 0 || !case_scaled(question, of_direction ? steps : lengths, &moved))
            continue;
        outcome o = ask(&moved, tier);
        if (is_void(tier, plain, &o))
            continue;
        ++*checked;
        if (!same_outcome(tier, plain, &o, of_direction ? -k : k, plain->normal))
            return false;
    }
    return true;
}

/* Law 3: negating one coordinate of everything, or exchanging x and y. */
static bool law_mirror(const sure_case *question, sure_tier tier, const outcome *plain,
                       unsigned long *checked)
{
    static const turn turns[] = {{{0, 1, 2}, {-1, 1, 1}},
                                 {{0, 1, 2}, {1, -1, 1}},
                                 {{0, 1, 2}, {1, 1, -1}},
                                 {{1, 0, 2}, {1, 1, 1}}};
    for (int i = 0; i < 4; i++) {
        sure_case moved = case_turned(question, &turns[i]);
        outcome o = ask(&moved, tier);
        sure_vec3 normal = vector_turned(plain->normal, &turns[i]);
        if (plain->guess != o.guess)
            return false;
        if (shape_has(question->object.shape, SURE_KIND_HIGH)) { /* faces have other names */
            o.hit.part = plain->hit.part;
            o.normal = normal;
        }
        ++*checked;
        if (!same_outcome(tier, plain, &o, 0, normal))
            return false;
    }
    return true;
}

/* A hit's t is an end of the chord, or t_min on one that lies in the boundary; the ray leaves a
 * solid at the second end alone, and just where the chord has begun before t_min. */
static bool is_of_chord(const sure_hit *hit, const sure_interval *chord, double t_min, bool solid)
{
    bool second = hit->t == chord->t_leave && hit->part == chord->leave_part;
    if (hit->leaves)
        return solid && second && chord->t_enter <= t_min;
    if (solid && second && chord->t_enter < t_min && t_min < chord->t_leave)
        return false;
    if (second || (hit->t == chord->t_enter && hit->part == chord->enter_part))
        return true;
    return hit->t == t_min && chord->t_enter <= t_min && t_min <= chord->t_leave;
}

/* Has the hit that end's part, or is it t_min? */
static bool is_like_chord(const sure_hit *hit, const sure_interval *chord, double t_min)
{
    return hit->part == chord->enter_part || hit->part == chord->leave_part || hit->t == t_min;
}

/* Law 4: occluded's status is hit's; a hit is of the chord. Certain's and stable's chords need not
 * have the bits of their hits: one may be certain where the other is not. What certain's are is
 * told by law 8. */
static bool law_questions_agree(const sure_case *question, sure_tier tier, const outcome *plain)
{
    sure_interval chord;
    sure_status interval = sure_object_interval(&question->ray, &question->object, tier, &chord);
    if (sure_object_occluded(&question->ray, &question->object, tier) != plain->status)
        return false;
    if ((interval == SURE_INVALID) != (plain->status == SURE_INVALID))
        return false;
    if (interval == SURE_HIT && !(chord.t_enter <= chord.t_leave))
        return false;
    if (plain->status != SURE_HIT)
        return true;
    double t_min = question->ray.t_min;
    if (interval != SURE_HIT || tier == SURE_TIER_CERTAIN)
        return interval == SURE_HIT;
    if (tier == SURE_TIER_STABLE)
        return is_like_chord(&plain->hit, &chord, t_min);
    return is_of_chord(&plain->hit, &chord, tier == SURE_TIER_FLOAT32 ? (float)t_min : t_min,
                       sure_shape_info_of(question->object.shape)->solid);
}

/* Law 5: on miss and invalid no output is touched; invalid exactly when check names a field. */
static bool law_untouched(const sure_case *question, sure_tier tier)
{
    sure_hit hit, hit_before;
    sure_interval chord, chord_before;
    memset(&hit, 0xa5, sizeof hit);
    memset(&chord, 0xa5, sizeof chord);
    hit_before = hit;
    chord_before = chord;
    sure_status status = sure_object_hit(&question->ray, &question->object, tier, &hit);
    sure_status interval = sure_object_interval(&question->ray, &question->object, tier, &chord);
    bool valid = sure_object_check(&question->ray, &question->object) == SURE_FIELD_NONE;
    return (status == SURE_INVALID) == !valid &&
           (status == SURE_HIT || memcmp(&hit, &hit_before, sizeof hit) == 0) &&
           (interval == SURE_HIT || memcmp(&chord, &chord_before, sizeof chord) == 0);
}

/* Law 6: where decisions are right a range that is cut at the double above t + t_error, whose sum
 * may be rounded below t*, keeps the hit. */
static bool law_cut(const sure_case *question, sure_tier tier, const outcome *plain)
{
    if (plain->status != SURE_HIT || !is_sure(tier))
        return true;
    sure_case cut = *question;
    double end = nextafter(plain->hit.t + plain->hit.t_error, INFINITY);
    cut.ray.t_max = fmin(end, cut.ray.t_max);
    outcome o = ask(&cut, tier);
    return o.status == SURE_HIT && o.hit.part == plain->hit.part;
}

/* Law 6: widening [t_min, t_max] never turns a hit into a miss. Where decisions are right it does
 * not put it off either. */
static bool law_wider(const sure_case *question, sure_tier tier, const outcome *plain)
{
    if (plain->status != SURE_HIT)
        return true;
    sure_case wider = *question;
    wider.ray.t_min = 0;
    wider.ray.t_max = INFINITY;
    outcome o = ask(&wider, tier);
    return o.status == SURE_HIT && (!is_sure(tier) || o.hit.t <= plain->hit.t ||
                                    meet(o.hit.t, o.hit.t_error, plain->hit.t, plain->hit.t_error));
}

/* Law 7: t lies in [t_min, t_max] of the tier's precision. The normal is a unit vector as far as
 * that shows without a tolerance of one's own: no component beyond 1, or for certain beyond its
 * bound, the largest not below 1/2, none a NaN. */
static bool law_in_range(const sure_case *question, sure_tier tier, const outcome *plain)
{
    double t_min = question->ray.t_min, t_max = question->ray.t_max;
    if (tier == SURE_TIER_FLOAT32) {
        t_min = (float)t_min;
        t_max = (float)t_max;
    }
    if (plain->status != SURE_HIT)
        return true;
    sure_vec3 n = plain->normal;
    double largest = fmax(fabs(n.x), fmax(fabs(n.y), fabs(n.z)));
    double most = tier == SURE_TIER_CERTAIN ? 1 + SURE_NORMAL_ERROR : 1;
    bool unit = fabs(n.x) <= most && fabs(n.y) <= most && fabs(n.z) <= most && largest >= 0.5;
    return t_min <= plain->hit.t && plain->hit.t <= t_max && unit;
}

/* Half the step from t >= 0 upwards, the least number for less. */
static double half_ulp(double t)
{
    return t == INFINITY ? INFINITY : fmax((nextafter(t, INFINITY) - t) / 2, 0x1p-1074);
}

/* Is an error of t, besides half an ulp, within SURE_T_ERROR_CAP? */
static bool within_cap(const sure_case *question, double error, double t)
{
    return error <= half_ulp(fabs(t)) ||
           error * long_length(long_of(question->ray.direction)) <=
               SURE_T_ERROR_CAP * object_reach(question->ray.origin, &question->object);
}

/* An end of certain's chord, held against the exact one. */
static bool end_near(const sure_case *question, double t, double exact)
{
    return t == exact || (isfinite(t) && within_cap(question, fabs(t - exact), exact));
}

static bool chord_near(const sure_case *question)
{
    sure_interval certain, exact;
    sure_status status =
        sure_object_interval(&question->ray, &question->object, SURE_TIER_CERTAIN, &certain);
    if (sure_object_interval(&question->ray, &question->object, SURE_TIER_EXACT, &exact) != status)
        return false;
    return status != SURE_HIT ||
           (certain.enter_part == exact.enter_part && certain.leave_part == exact.leave_part &&
            end_near(question, certain.t_enter, exact.t_enter) &&
            end_near(question, certain.t_leave, exact.t_leave));
}

/* Law 8: certain and exact agree in status, part and leaves; t and normal are as near as certain
 * says, and t_error is within its bounds. */
static bool law_sure(const sure_case *question, const outcome *certain)
{
    outcome exact = ask(question, SURE_TIER_EXACT);
    if (certain->status != exact.status || !chord_near(question))
        return false;
    if (certain->status != SURE_HIT)
        return true;
    return certain->hit.part == exact.hit.part && certain->hit.leaves == exact.hit.leaves &&
           meet(certain->hit.t, certain->hit.t_error, exact.hit.t, half_ulp(exact.hit.t)) &&
           within_cap(question, certain->hit.t_error, certain->hit.t) &&
           near_vector(certain->normal, exact.normal, SURE_NORMAL_ERROR + 0x1p-54);
}

/* Law 9: where the first stage decides, stable's answer is certain's, bit for bit; and where
 * t_error is a number, the hit is right and t within it. */
static bool law_first_stage(const sure_case *question, const outcome *stable)
{
    const sure_hit *hit = &stable->hit;
    outcome certain = ask(question, SURE_TIER_CERTAIN);
    sure_stage stage = sure_object_stage(&question->ray, &question->object, SURE_TIER_CERTAIN);
    if (stage == SURE_STAGE_DOUBLE)
        return stable->status == certain.status &&
               (certain.status != SURE_HIT ||
                (hit->part == certain.hit.part && hit->leaves == certain.hit.leaves &&
                 hit->t == certain.hit.t && hit->t_error == certain.hit.t_error));
    return stable->status != SURE_HIT || hit->t_error == INFINITY ||
           (certain.status == SURE_HIT && hit->part == certain.hit.part &&
            meet(hit->t, hit->t_error, certain.hit.t, certain.hit.t_error));
}

const char *shape_law_broken(const sure_case *question, sure_tier tier, unsigned long *checked)
{
    outcome plain = ask(question, tier);
    *checked += tier == SURE_TIER_CERTAIN || tier == SURE_TIER_STABLE ? 5 : 4;
    if (!law_untouched(question, tier))
        return "Law 5: outputs untouched on miss and invalid, invalid when check says so";
    if (!law_questions_agree(question, tier, &plain))
        return "Law 4: hit, interval and occluded agree";
    if (!law_wider(question, tier, &plain))
        return "Law 6: a wider t range keeps the hit";
    if (!law_cut(question, tier, &plain))
        return "Law 6: a t range cut above t + t_error keeps the hit";
    if (!law_in_range(question, tier, &plain))
        return "Law 7: t in its range, the normal a unit vector";
    if (tier == SURE_TIER_CERTAIN && !law_sure(question, &plain))
        return "Law 8: certain is as near to exact as it says";
    if (tier == SURE_TIER_STABLE && !law_first_stage(question, &plain))
        return "Law 9: stable is certain where the first stage is";
    if (plain.status == SURE_INVALID)
        return NULL;
    if (!law_scale(question, tier, &plain, false, checked))
        return "Law 1: scaling origin, object and t range by a power of two";
    if (!law_scale(question, tier, &plain, true, checked))
        return "Law 2: scaling the direction by a power of two";
    if (!law_mirror(question, tier, &plain, checked))
        return "Law 3: negating a coordinate or exchanging x and y";
    return NULL;
}

/* SPDX-License-Identifier: MIT */
/* Answers without a branch: whether a ray hits, and by which end of a chord, is as good as random.
 * docs/proofs/stages.md */
#pragma once

#include "filter.h"

#include <surehit/answer.h>

#include <stddef.h>

/* part and leaves, as the bytes of one number. */
static inline void *hit_names(sure_hit *hit)
{
    return (char *)hit + offsetof(sure_hit, part);
}

/* That number. By shifts: two halves that have just been stored are no number yet for a while. */
static inline uint64_t hit_names_of(sure_hit answer)
{
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    return (uint64_t)(uint32_t)answer.leaves << 32 | (uint32_t)answer.part;
#else
    uint64_t names;
    memcpy(&names, hit_names(&answer), sizeof names);
    return names;
#endif
}

/* *hit = answer where `met` is all ones, and stays as it is where that is 0. It is written in any
 * case: a store to a place that is chosen late holds up the loads behind it. */
static inline void hit_where(uint64_t met, sure_hit answer, sure_hit *hit)
{
    uint64_t names = hit_names_of(answer), before;
    memcpy(&before, hit_names(hit), sizeof before);
    names = filter_either_bits(met, names, before);
    hit->t = filter_either(met, answer.t, hit->t);
    hit->t_error = filter_either(met, answer.t_error, hit->t_error);
    memcpy(hit_names(hit), &names, sizeof names);
}

/* What certain says of one ray before a solid: as filter_first, but the end is chosen before, the
 * first or from behind it the second, and what else must be certain is asked of that end alone. */
typedef struct {
    uint64_t leaves;       /* all ones: the second */
    double start, t, deep; /* from t_min to the first end; its t; how far that is in the range */
} decision_end;

static INLINED decision_end decision_end_of(double enter, double leave, const sure_ray *ray)
{
    double start = enter - ray->t_min;
    uint64_t leaves = bits_unknown(-(bits_of(start) >> 63));
    double t = filter_choose(filter_negative(start), leave, enter);
    return (decision_end){leaves, start, t, filter_lesser(t - ray->t_min, ray->t_max - t)};
}

typedef struct {
    bool certain;
    uint64_t meets; /* all ones, or 0 */
    sure_hit hit;
} decided;

/* chord: positive where the line has one, negative where it has none, if that is `known`. clear: is
 * the chosen end then on `part`? first_error: of the first end; error: of the chosen one. Not of a
 * range of one point. Entry: a known chord has finite ends, for a lesser of two may hide a NaN. */
static INLINED decided decision_of(const decision_end *at, double chord, bool known, bool clear,
                                   double first_error, double error, uint64_t part,
                                   const sure_ray *ray)
{
    /* Read anew: no register of doubles waits to be told as bits. */
    const sure_ray *again = (const sure_ray *)(uintptr_t)bits_unknown((uintptr_t)ray);
    uint64_t least = bits_of(again->t_min), most = bits_of(again->t_max);
    double beyond = filter_lesser(fabs(at->start) - first_error, fabs(at->deep) - error);
    uint64_t none = bits_of(chord) >> 63, out = none | bits_of(at->deep) >> 63;
    bool certain = least < most && most <= FILTER_ENDLESS &&
                   bits_unknown(known & (none | (uint64_t)(clear & (beyond > 0)))) != 0;
    assert(!certain || none || (is_finite_bits(at->start) && is_finite_bits(at->t)));
    return (decided){
        .certain = certain,
        .meets = out - 1,
        .hit = {at->t, error, (sure_part)part, (int)(at->leaves & 1)},
    };
}

/* Entry: it is certain. */
static INLINED sure_status decision_tell(const decided *said, sure_hit *hit)
{
    hit_where(said->meets, said->hit, hit);
    return said->meets ? SURE_HIT : SURE_MISS;
}

/* SPDX-License-Identifier: MIT */
/* A hit that may be none, without a branch: which it is is as good as random. */
#pragma once

#include "bits.h"

#include <surehit/answer.h>

#include <stddef.h>
#include <string.h>

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

/* *hit = answer where it is met, else what it was. The place is written in any case: a store to one
 * that is chosen late holds up the loads behind it, by chance of where the code lies. */
static inline void hit_where(bool met, sure_hit answer, sure_hit *hit)
{
    const uint64_t bits = -(uint64_t)met;
    uint64_t names = hit_names_of(answer), before;
    memcpy(&before, hit_names(hit), sizeof before);
    names = (names & bits) | (before & ~bits);
    hit->t = double_of((bits_of(answer.t) & bits) | (bits_of(hit->t) & ~bits));
    hit->t_error = double_of((bits_of(answer.t_error) & bits) | (bits_of(hit->t_error) & ~bits));
    memcpy(hit_names(hit), &names, sizeof names);
}

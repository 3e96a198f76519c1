/* SPDX-License-Identifier: MIT */
#include "textbook_bench.h"

/* Its own source, under other names than a candidate's. */
#define PEER_FLOAT
#include "precision.h"
#undef PEER
#define PEER(shape) peer_##shape
#define sure_candidate_version peer_version
extern const int peer_version;

#define DECLARE_PEER(shape, SHAPE)                                                                 \
    static int peer_##shape(const real *numbers, const real *shape, peer_hit *hit);
SURE_EACH_SHAPE(DECLARE_PEER)
#include "textbook_float.c"

#define HIT(shape, SHAPE)                                                                          \
    sure_status textbook_##shape##_hit_f(const sure_ray_f *ray, const sure_##shape##_f *shape,     \
                                         sure_hit_f *hit)                                          \
    {                                                                                              \
        peer_hit found;                                                                            \
        const int said = peer_##shape((const real *)ray, (const real *)shape, &found);             \
        if (said == SURE_CANDIDATE_HIT)                                                            \
            hit->t = found.t;                                                                      \
        return said == SURE_CANDIDATE_HIT ? SURE_HIT : SURE_MISS;                                  \
    }
SURE_EACH_SHAPE(HIT)

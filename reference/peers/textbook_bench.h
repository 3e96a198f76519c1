/* SPDX-License-Identifier: MIT */
/* The peer textbook_float for the bench. Speeds are published as ratios to it, so that it is FROZEN
 * (naive.h). */
#ifndef PEERS_TEXTBOOK_BENCH_H
#define PEERS_TEXTBOOK_BENCH_H

#include <surehit/floats.h>

/* As of naive.h. */
#define DECLARE_TEXTBOOK(shape, SHAPE)                                                             \
    sure_status textbook_##shape##_hit_f(const sure_ray_f *ray, const sure_##shape##_f *shape,     \
                                         sure_hit_f *hit);
SURE_EACH_SHAPE(DECLARE_TEXTBOOK)
#undef DECLARE_TEXTBOOK

#endif

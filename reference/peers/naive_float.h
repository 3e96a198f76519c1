/* SPDX-License-Identifier: MIT */
/* The naive peers in single precision: their own sources, with float in the place of double. */
#ifndef PEERS_NAIVE_FLOAT_H
#define PEERS_NAIVE_FLOAT_H

#include <surehit/floats.h>

/* As of naive.h. */
#define DECLARE_NAIVE(shape, SHAPE)                                                                \
    sure_status naive_##shape##_hit_f(const sure_ray_f *ray, const sure_##shape##_f *shape,        \
                                      sure_hit_f *hit);
SURE_EACH_SHAPE(DECLARE_NAIVE)
#undef DECLARE_NAIVE

#endif

/* SPDX-License-Identifier: MIT */
/* The naive peers for many rays before one object, as one writes them for a compiler that computes
 * several side by side: without a branch. FROZEN (naive.h). */
#ifndef PEERS_NAIVE_BLOCK_H
#define PEERS_NAIVE_BLOCK_H

#include <surehit/object.h>

#include <stddef.h>
#include <stdint.h>

/* `ray`: eight columns, in the order of sure_ray's numbers. Of each ray SURE_HIT or SURE_MISS; t
 * and, where there are several, part: of a miss they mean nothing. */
typedef void naive_hits(size_t count, const double *const ray[8], const void *object,
                        uint8_t *restrict status, uint8_t *restrict part, double *restrict t);

/* For the widest vectors that this processor has, and that the environment variable SUREHIT_LANES
 * allows; NULL where it allows 1, or the compiler makes none. */
naive_hits *naive_hits_of(sure_shape shape);

#endif

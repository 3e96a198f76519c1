/* SPDX-License-Identifier: MIT */
/* The naive peers: the first hit as a competent programmer writes it in plain double for speed.
 *
 * They stand for the code found in ray tracers: the textbook formulas by the chord, a quarter of
 * the discriminant, as few divisions as possible and early exits where they pay; no check of the
 * input, no bound of any error, nothing against overflow. A line parallel to a face, to the wall or
 * to a generator is left to what infinities and NaNs make of it.
 *
 * Speeds are published as ratios to these routines. They are FROZEN: never tuned, corrected or
 * brought up to date again. */
#ifndef PEERS_NAIVE_H
#define PEERS_NAIVE_H

#include <surehit/object.h>

/* SURE_HIT, hit->t and, where there are several, hit->part; or SURE_MISS and *hit untouched. */
#define DECLARE_NAIVE(shape, SHAPE)                                                                \
    sure_status naive_##shape##_hit(const sure_ray *ray, const sure_##shape *shape, sure_hit *hit);
SURE_EACH_SHAPE(DECLARE_NAIVE)
#undef DECLARE_NAIVE

#endif

/* SPDX-License-Identifier: MIT */
/* What a shape computes in double-doubles. Half of it are exact products, so it is compiled once
 * more for processors that multiply and add in one (src/shapes/close.c). The answers are the same.
 */
#pragma once

#include "shape.h"

struct axial_terms;

/* spawn_quick.h */
typedef bool spawning(const sure_ray *, const void *shape, const sure_hit *, double side,
                      sure_vec3 *origin, sure_hit *nearer);

/* Entry of all: round to nearest. */
typedef struct {
    /* In the place of a row's refine and of step for hits of planar shapes. */
    filter_verdict (*refine_hit)(const sure_ray *, const void *shape, t_wanted, sure_hit *);

    /* How t of an end that is certain and no tangent is polished. */
    polish_stepping *step;

    /* Of a body D as a difference; and the filter once more, by a D that is known. */
    two_terms_dd (*discriminant)(const sure_ray *, const void *shape);
    filter_verdict (*filter)(const sure_ray *, const void *shape, const struct axial_terms *,
                             const known_discriminant *, filter_interval *);

    /* What sure_spawn tries first. */
    spawning *spawn;
} close_row;

extern const close_row close_rows[SURE_SHAPES], close_rows_fused[SURE_SHAPES];

/* The faster of both that this processor has. */
static inline const close_row *close_of(const shape_row *row)
{
#ifdef SURE_FUSED
    if (__builtin_cpu_supports("fma"))
        return &close_rows_fused[row->shape];
#endif
    return &close_rows[row->shape];
}

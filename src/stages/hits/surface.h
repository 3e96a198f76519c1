/* SPDX-License-Identifier: MIT */
/* What a shape tells of its surface, at a hit or near it. Curved parts are seen from `anchor`. */
#pragma once

#include "../../numbers/ddb.h"
#include "../shape.h"

/* A planar part: through `at`, its outward normal is to - from. */
typedef struct {
    sure_vec3 from, to, at;
} part_plane;

/* F at p and along d: F(p + s d) = f + 2 s half_slope + s^2 (bend.more - bend.less), with no term
 * of bend below 0. */
typedef struct {
    ddb f, half_slope;
    two_terms_ddb bend;
} part_slope;

typedef struct surface_row {
    /* False: a curved part; NULL: there are no others. */
    bool (*plane)(const void *shape, sure_part, part_plane *);
    int anchor; /* so many doubles of the struct stand before it */
    part_slope (*slope)(ddb_context *, const void *shape, vector_ddb p, vector_ddb d);
    /* half_slope at o + x d: as doubles have it, what its terms come to, and whole. */
    double (*slope_f64)(const sure_ray *, const void *shape, double x);
    double (*slope_most)(const sure_ray *, const void *shape, double x);
    mod128 (*slope_mod128)(const sure_ray *, const void *shape, double x);
    vector_ddb (*unit_normal)(ddb_context *, const void *shape, vector_ddb p);

    /* On which side a point is: -1 in a solid's interior, 0 on its boundary, 1 outside the closed
     * solid; for plane and disc the sign of N.(p - Q). Where doubles tell it, `side` does; else it
     * is the greatest of the signs of the numbers in `of`. Returns how many these are. */
    int (*sides_ddb)(ddb_context *, const void *shape, sure_vec3 p, ddb of[3]);
    int (*sides_mod128)(mod128_context *, const void *shape, sure_vec3 p, mod128 of[3]);
    int (*sides_exact)(exact_context *, const void *shape, sure_vec3 p, exact of[3]);
    int (*side)(const void *shape, sure_vec3 p);
    bool (*has_inside)(const void *shape); /* NULL: always */

    /* Of a solid that may be flat: is it? Then *part is the face that a ray along d comes to, the
     * one of two that coincide whose outward normal is against d; as it was where d runs in all of
     * them. NULL: never. */
    bool (*flat_part)(const void *shape, const sure_vec3 *d, sure_part *part);

    /* What spawn.c tries first. */
    sure_vec3 (*outward)(const void *shape, sure_part part, sure_vec3 p);

    /* Makes a box larger, so that it holds the object; NULL where no box does. */
    void (*bounds)(const void *shape, double low[3], double high[3]);
} surface_row;

/* These as <shape>_tmpl.h has them. */
#define SURFACE_SLOPES(shape)                                                                      \
    .slope_f64 = shape##_slope_at_f64, .slope_most = shape##_slope_at_most,                        \
    .slope_mod128 = shape##_slope_at_mod128
#define SURFACE_SIDES(shape)                                                                       \
    .sides_ddb = shape##_sides_ddb, .sides_mod128 = shape##_sides_mod128,                          \
    .sides_exact = shape##_sides_exact

static inline sure_vec3 surface_anchor(const shape_row *row, const void *shape)
{
    return *(const sure_vec3 *)((const double *)shape + row->surface->anchor);
}

/* flat_part, for any shape. */
static inline bool surface_flat_part(const shape_row *row, const void *shape, const sure_vec3 *d,
                                     sure_part *part)
{
    return row->surface->flat_part && row->surface->flat_part(shape, d, part);
}

/* o + t d - from */
vector_ddb surface_point(ddb_context *c, const sure_ray *ray, sure_vec3 from, ddb t);

/* The same for t = at + step. That sum is not rounded: step may be far less than at. */
vector_ddb surface_point_after(ddb_context *c, const sure_ray *ray, sure_vec3 from, ddb at,
                               ddb step);

/* The part's slope at o + t d. */
part_slope surface_slope(ddb_context *c, const shape_row *row, const sure_ray *ray,
                         const void *shape, ddb t);

/* Of a hit by certain or exact t* is in the range. Twice its error is room for what is rounded
 * here. */
static inline bool hit_in_range(const sure_ray *ray, const sure_hit *hit)
{
    double room = 2 * hit->t_error + 0x1p-1000; /* subnormals may be flushed */
    return !(hit->t + room < ray->t_min || hit->t - room > ray->t_max);
}

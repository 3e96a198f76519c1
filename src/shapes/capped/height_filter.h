/* SPDX-License-Identifier: MIT */
/* The first stage of the heights for certain and exact: doubles with a proven bound
 * (docs/proofs/height.md). */
#pragma once

#include "../../stages/filter.h"

#include "../../numbers/most.h" /* a type, where variables in filter.h have its name */

#include <stddef.h>

/* height_tmpl.h says of what the sign is asked. */
typedef struct {
    sure_vec3 from, to, point;
    sure_vec3 end;
    double radius;
    bool slant;
} height_query;

#define NUMBER f64
#include "height_tmpl.h"
#define NUMBER most
#include "height_tmpl.h"

/* Coordinates that are farther apart may overflow in products; ... */
#define HEIGHT_FAR 0x1p400
/* ... of nearer ones no more than this is flushed. */
#define HEIGHT_FLOOR 0x1p-616

static inline double height_reach(const height_query *q)
{
    vector_most a = vector_between_most(NULL, q->from, q->to);
    vector_most p = vector_between_most(NULL, q->from, q->point);
    vector_most e = vector_between_most(NULL, q->end, q->point);
    return (a.x + a.y + a.z) + (p.x + p.y + p.z) + (e.x + e.y + e.z) + most_of(NULL, q->radius);
}

/* The value; false unless its sign is certain. */
static inline bool height_filter(const height_query *q, double *value)
{
    double error = SURE_HEIGHT_BOUND * height_most(NULL, q) + HEIGHT_FLOOR;
    *value = height_f64(NULL, q);
    return height_reach(q) < HEIGHT_FAR && fabs(*value) > error;
}

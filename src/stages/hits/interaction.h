/* The surface at a hit, in double-doubles with a bound: t* from the hit's t by a step of Newton's
 * method, then the point and the normal. */
#ifndef STAGES_INTERACTION_H
#define STAGES_INTERACTION_H

#include "../../numbers/ddb.h"

#include <surehit/answer.h>
#include <surehit/ray.h>

/* A planar part: through `at`, its outward normal is to - from. */
typedef struct {
    sure_vec3 from, to, at;
} part_plane;

/* F at p and along d: F(p + s d) = f + 2 s half_slope + s^2 a, |a| <= bend. */
typedef struct {
    ddb f, half_slope, bend;
} part_slope;

/* What a shape says of its parts. Points p are seen from `anchor`. */
typedef struct {
    bool (*plane)(const void *shape, sure_part, part_plane *); /* false: a curved part */
    sure_vec3 (*anchor)(const void *shape);
    part_slope (*slope)(ddb_context *, const void *shape, vector_ddb p, vector_ddb d);
    vector_ddb (*unit_normal)(ddb_context *, const void *shape, vector_ddb p);
} surface_functions;

struct shape_row;

/* The double nearest to a number known nearly, when its error leaves no other; not for numbers near
 * the ends of the range. */
static inline bool interaction_rounds_to(ddb x, double *rounded)
{
    double slack = x.error * (1 + 0x1p-40) + fabs(x.lo) * 0x1p-50;
    *rounded = x.hi;
    return fabs(x.hi) > 0x1p-900 && x.hi + (x.lo + slack) == x.hi && x.hi + (x.lo - slack) == x.hi;
}

/* The hit point o + t* d, correctly rounded. Entry for both: a hit by certain or exact, round to
 * nearest. False where it can't be told. */
bool interaction_point(const struct shape_row *row, const sure_ray *ray, const void *shape,
                       const sure_hit *hit, sure_vec3 *point);

/* Each component of the normal within SURE_NORMAL_ERROR, or rounded correctly. */
bool interaction_normal(const struct shape_row *row, const sure_ray *ray, const void *shape,
                        const sure_hit *hit, bool rounded, sure_vec3 *normal);

#endif

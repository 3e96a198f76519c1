/* A disc of radius r across the axis A reaches
 *
 *     e_i = r sqrt((A_j^2 + A_k^2) / A.A)
 *
 * to either side of its centre along coordinate i. A cylinder is spanned by two discs, a cone by
 * one and its apex: both are convex. */
#include "../numbers/ieee.h"

#include <surehit/bvh.h>

#include <math.h>
#include <stdbool.h>

/* More than the roundings of e_i, some eight of 2^-52, and than what is flushed in its squares. */
#define REACH_SHARE (1 + 0x1p-48)
#define REACH_MORE 0x1p-60
/* Out of this range squares are not known; then r itself is reach enough. */
#define REACH_LEAST 0x1p-900
#define REACH_MOST 0x1p1000

/* More than is flushed on the way to a face, two numbers of less than 2^-1022. */
#define REACH_FLUSHED 0x1p-1019

/* Where something that rounds to x may lie: a double further, in any rounding mode. */
static double above(double x)
{
    double further = x + (fabs(x) * 0x1p-52 + REACH_FLUSHED);
    return further > SURE_BVH_FAR ? INFINITY : further < -SURE_BVH_FAR ? -SURE_BVH_FAR : further;
}

static double below(double x)
{
    return -above(-x);
}

static void include(sure_vec3 p, const double reach[3], sure_box *box)
{
    const double at[3] = {p.x, p.y, p.z};
    for (int i = 0; i < 3; i++) {
        double low = below(at[i] - reach[i]), high = above(at[i] + reach[i]);
        box->low[i] = low < box->low[i] ? low : box->low[i];
        box->high[i] = high > box->high[i] ? high : box->high[i];
    }
}

static void reach_of_disc(sure_vec3 axis, double r, double reach[3])
{
    const double square[3] = {axis.x * axis.x, axis.y * axis.y, axis.z * axis.z};
    double whole = square[0] + square[1] + square[2];
    bool known = whole > REACH_LEAST && whole < REACH_MOST;
    for (int i = 0; i < 3; i++) {
        double across = square[(i + 1) % 3] + square[(i + 2) % 3];
        double share = known ? REACH_SHARE * sqrt(across / whole) + REACH_MORE : 1;
        reach[i] = share < 1 ? r * share : r;
    }
}

static sure_vec3 between(sure_vec3 from, sure_vec3 to)
{
    return (sure_vec3){to.x - from.x, to.y - from.y, to.z - from.z};
}

int sure_bvh_box(const sure_object *object, sure_box *box)
{
    const double none[3] = {0, 0, 0};
    double reach[3];
    if (object->shape == SURE_SHAPE_PLANE)
        return 0;
    for (int i = 0; i < 3; i++) {
        box->low[i] = INFINITY;
        box->high[i] = -INFINITY;
    }
    if (object->shape == SURE_SHAPE_SPHERE) {
        const sure_sphere *s = &object->as.sphere;
        reach[0] = reach[1] = reach[2] = s->radius;
        include(s->centre, reach, box);
    } else if (object->shape == SURE_SHAPE_DISC) {
        const sure_disc *s = &object->as.disc;
        reach_of_disc(s->normal, s->radius, reach);
        include(s->centre, reach, box);
    } else if (object->shape == SURE_SHAPE_CYLINDER) {
        const sure_cylinder *s = &object->as.cylinder;
        reach_of_disc(between(s->base, s->top), s->radius, reach);
        include(s->base, reach, box);
        include(s->top, reach, box);
    } else {
        const sure_cone *s = &object->as.cone;
        reach_of_disc(between(s->apex, s->base), s->radius, reach);
        include(s->base, reach, box);
        include(s->apex, none, box);
    }
    return 1;
}

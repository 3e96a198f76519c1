#define SURE_PAIR
#include "axial_close.h"

#include "../../numbers/number.h"

#include <stddef.h>

/* Keeps quotients by A.d finite, and is of no account for pairs either. */
#define PAIR_TILT 0x1p-300

/* The ends as pairs; their heads are the line's. */
typedef struct {
    pair less, more, base, top;
    pair e;
} ends;

static pair quotient(pair n, pair d)
{
    return pair_div(NULL, n, d);
}

static double gap(pair x, pair y)
{
    return (x.head - y.head) + (x.tail - y.tail);
}

/* A.d, or what stands for one that is next to nothing. */
static pair tilted(pair e)
{
    return fabs(e.head) < PAIR_TILT ? (pair){PAIR_TILT, 0} : e;
}

static filter_verdict decide(const ends *at, axial_line *line, double dd, double size,
                             const sure_ray *ray, filter_chord *found)
{
    bool rising = gap(at->top, at->base) > 0;
    pair low = rising ? at->base : at->top, high = rising ? at->top : at->base;
    axial_gaps gaps = {gap(low, at->less), gap(at->more, high),
                       filter_lesser(gap(high, at->less), gap(at->more, low)), gap(high, low)};
    line->less = at->less.head;
    line->more = at->more.head;
    line->base = at->base.head;
    line->top = at->top.head;
    filter_verdict verdict = axial_decide(line, gaps, dd, size, ray, found);
    if (verdict == FILTER_CHORD) {
        found->enter.error += 0x1p-52 * fabs(found->enter.t);
        found->leave.error += 0x1p-52 * fabs(found->leave.t);
    }
    return verdict;
}

filter_verdict cylinder_close(const sure_ray *ray, const sure_cylinder *cylinder,
                              const cylinder_terms *of, const quarter *known, filter_chord *found)
{
    vector axis = vector_between(NULL, cylinder->base, cylinder->top);
    vector m = vector_between(NULL, cylinder->base, ray->origin);
    vector d = vector_of(NULL, ray->direction);
    pair height = vector_square(NULL, axis), a = vector_square(NULL, vector_cross(NULL, axis, d));
    pair e = tilted(vector_dot(NULL, axis, d)), f = vector_dot(NULL, axis, m);
    pair b = number_minor(NULL, height, e, f, vector_dot(NULL, m, d));
    pair root = pair_sqrt(NULL, number_mul(NULL, height, (pair){known->value, known->rest}));
    double reach = of->height * of->size;
    ends at = {.less = quotient(number_negate(NULL, number_add(NULL, b, root)), a),
               .more = quotient(number_sub(NULL, root, b), a),
               .base = quotient(number_negate(NULL, f), e),
               .top = quotient(number_sub(NULL, height, f), e)};
    axial_line line = {
        .less_at = POINT_LESS,
        .more_at = POINT_MORE,
        .e = e.head,
        .wall_error = (PAIR_SHARE * SURE_CYLINDER_WALL_BOUND * sqrt(of->height * of->dd * reach) +
                       known->error * of->height / root.head) /
                      fabs(a.head),
        .plane_error = PAIR_SHARE * SURE_AXIAL_PLANE_BOUND * sqrt(reach) / fabs(e.head),
        .leading = true,
    };
    return decide(&at, &line, of->dd, of->size, ray, found);
}

filter_verdict cone_close(const sure_ray *ray, const sure_cone *cone, const cone_terms *of,
                          const quarter *known, filter_chord *found)
{
    vector axis = vector_between(NULL, cone->apex, cone->base);
    vector m = vector_between(NULL, cone->apex, ray->origin);
    vector d = vector_of(NULL, ray->direction);
    pair height = vector_square(NULL, axis);
    pair slant = number_add(NULL, height, number_square(NULL, number_of(NULL, cone->radius)));
    pair e = tilted(vector_dot(NULL, axis, d)), f = vector_dot(NULL, axis, m);
    pair level = number_mul(NULL, height, vector_square(NULL, d));
    pair share = number_mul(NULL, slant, e); /* K A.d */
    pair a = number_minor(NULL, height, share, e, level);
    pair b = number_minor(NULL, height, share, f, number_mul(NULL, height, vector_dot(NULL, m, d)));
    pair root = number_mul(NULL, height, pair_sqrt(NULL, (pair){known->value, known->rest}));
    double all = of->height * of->height * of->dd + of->slant * (e.head * e.head);
    double reach = of->height * of->size, a_bound = PAIR_SHARE * SURE_CONE_LEADING_BOUND;
    bool steep = a.head < 0;
    const pair out_of_sight = {0x1p600, 0};
    ends at = {.less = quotient(number_negate(NULL, number_add(NULL, b, root)), a),
               .more = quotient(number_sub(NULL, root, b), a),
               .base = quotient(number_sub(NULL, height, f), e),
               .top = quotient(number_negate(NULL, f), e)};
    if (steep && e.head > 0)
        at.more = out_of_sight;
    if (steep && e.head < 0)
        at.less = number_negate(NULL, out_of_sight);
    axial_line line = {
        .less_at = steep ? POINT_MORE : POINT_LESS,
        .more_at = steep ? POINT_LESS : POINT_MORE,
        .e = -e.head,
        .wall_error = (PAIR_SHARE * SURE_CONE_WALL_BOUND * sqrt(all * (of->slant * reach)) +
                       known->error * of->height * of->height / root.head) /
                      fabs(a.head),
        .plane_error = PAIR_SHARE * SURE_AXIAL_PLANE_BOUND * sqrt(reach) / fabs(e.head),
        .leading = a.head * a.head > a_bound * a_bound * all * (of->slant * of->height * of->dd),
    };
    return decide(&at, &line, of->dd, of->size, ray, found);
}

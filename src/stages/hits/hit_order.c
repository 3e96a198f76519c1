/* SPDX-License-Identifier: MIT */
/* |t - t*| <= t_error of both hits, so
 *
 *     t1* - t2* has the sign of t1 - t2 where |t1 - t2| > t_error1 + t_error2,
 *
 * and where that can't be told from the rounded sides, the exact stage tells the order. */
#include <surehit/hit_order.h>

#include "beyond.h"
#include "../rows.h"

#include <assert.h>

/* Both sides are rounded once (2^-52 in any mode), and so is their comparison's product; each
 * subnormal that is flushed changes them by less than 2^-1022. Where t or its error is infinite the
 * right side is, and nothing exceeds it. */
#define ORDER_SHARE (1 - 0x1p-50)
#define ORDER_FLUSHED 0x1p-1000

int sure_hit_order(const sure_ray *ray, const sure_object *first, const sure_hit *first_hit,
                   const sure_object *second, const sure_hit *second_hit)
{
    assert(hit_in_range(ray, first_hit) && hit_in_range(ray, second_hit));
    double gap = first_hit->t - second_hit->t;
    double error = first_hit->t_error + second_hit->t_error + ORDER_FLUSHED;
    if (ORDER_SHARE * fabs(gap) > error)
        return gap < 0 ? -1 : 1;
    return rounded_order(ray, row_of(first), &first->as, row_of(second), &second->as);
}

/* SPDX-License-Identifier: MIT */
/* What the notes ask of a point P near a capped shape, over any number. From `from` to `to` is A.
 *
 *     along    A.(P - end)                            beyond the plane through `end`, across A
 *     slant    r^2 + |A|^2 - |P - from|^2
 *              = r^2 - (P - to).((P - from) + A)      within the slant's length of `from`
 *
 * The slant's second form cancels less where P is near `to`: |A|^2 - |p|^2 = (A - p).(A + p) with
 * p = P - from and A - p = to - P. */
#include "../../numbers/number.h"

NUMBER_INLINE number OVER(height_along)(number_context *c, const height_query *q)
{
    return vector_dot(c, vector_between(c, q->from, q->to), vector_between(c, q->end, q->point));
}

NUMBER_INLINE number OVER(height_slant)(number_context *c, const height_query *q)
{
    vector p = vector_between(c, q->from, q->point), a = vector_between(c, q->from, q->to);
    number less = vector_dot(c, vector_between(c, q->to, q->point), vector_add(c, p, a));
    return number_sub(c, number_square(c, number_of(c, q->radius)), less);
}

NUMBER_INLINE number OVER(height)(number_context *c, const height_query *q)
{
    return q->slant ? OVER(height_slant)(c, q) : OVER(height_along)(c, q);
}

#undef NUMBER

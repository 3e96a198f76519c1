/* SPDX-License-Identifier: MIT */
/* Which of one ray's hits comes first. */
#pragma once

#include <surehit/object.h>

SURE_C_BEGIN

/* The order of the ray's hits on two objects: -1, 0 or +1 as the first one's t* is less than, equal
 * to or greater than the second one's. The real numbers are compared, not the t of the hits, which
 * may be equal where these are not. In a scene ties go to the object of the lower index.
 *
 * Entry    the hits that sure_<shape>_hit_certain or _exact returned for this ray and the objects.
 * Returns  -1, 0 or +1.
 * Bound    none needed: exactly right, in any rounding mode, subnormals flushed or not.
 * Source   docs/contract.md, "The answer".
 * Proof    docs/derivations/hit_order.md
 *
 * Law 1: exchanging the two changes the sign.
 * Law 2: of three hits, when none before the second and none before the third, then none before the
 *        third; an object ties with itself.
 * Law 3: t of `exact` is in the same order or equal. */
int sure_hit_order(const sure_ray *ray, const sure_object *first, const sure_hit *first_hit,
                   const sure_object *second, const sure_hit *second_hit);

SURE_C_END

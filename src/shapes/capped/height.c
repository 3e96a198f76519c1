/* SPDX-License-Identifier: MIT */
/* The heights of cylinder and cone for certain and exact, and the sides of any plane. One answer is
 * right, so both tiers have it. docs/proofs/height.md */
#include "height.h"
#include "height_filter.h"
#include "../../numbers/ddb.h"
#include "../../numbers/environment.h"
#include "../../numbers/exact.h"
#include "../../numbers/mod128_value.h"
#include "../../numbers/valid.h"

#include <surehit/cone_height.h>
#include <surehit/cylinder_height.h>

#include <assert.h>

#define NUMBER ddb
#include "height_tmpl.h"
#define NUMBER mod128
#include "height_tmpl.h"
#define NUMBER exact
#include "height_tmpl.h"

/* By double-doubles with a bound, then by the low bits; false where neither tells. */
static NOT_INLINED bool closely(const height_query *q, int *sign)
{
    ddb_context c = {false};
    ddb value = height_ddb(&c, q);
    *sign = ddb_sign(&c, value);
    return !c.uncertain || mod128_sign(ddb_most(value), height_mod128(NULL, q), sign);
}

static NOT_INLINED int exactly(const height_query *q)
{
    exact_arena room;
    exact_context c = exact_start(&room);
    return exact_sign(&c, height_exact(&c, q));
}

/* The stages. */
static int sign_of(const height_query *q)
{
    double value;
    bool known;
    int sign;
    if (height_filter(q, &value))
        return value > 0 ? 1 : -1;
    TO_NEAREST(known, closely(q, &sign));
    return known ? sign : exactly(q);
}

int part_plane_side(sure_vec3 from, sure_vec3 to, sure_vec3 at, sure_vec3 p)
{
    assert(all_finite(from) && all_finite(to) && all_finite(at) && all_finite(p));
    return sign_of(&(height_query){from, to, p, at, 0, false});
}

int sure_cylinder_height_certain(sure_vec3 point, const sure_cylinder *cylinder)
{
    assert(all_finite(point) && all_finite(cylinder->base) && all_finite(cylinder->top));
    assert(radius_ok(cylinder->radius) && !same_point(cylinder->base, cylinder->top));
    height_query above = {cylinder->base, cylinder->top, point, cylinder->base, 0, false};
    height_query beyond = above;
    beyond.end = cylinder->top;
    return sign_of(&above) >= 0 && sign_of(&beyond) <= 0;
}

int sure_cylinder_height_exact(sure_vec3 point, const sure_cylinder *cylinder)
{
    return sure_cylinder_height_certain(point, cylinder);
}

int sure_cone_height_certain(sure_vec3 point, const sure_cone *cone)
{
    assert(all_finite(point) && all_finite(cone->base) && all_finite(cone->apex));
    assert(radius_ok(cone->radius) && !same_point(cone->base, cone->apex));
    height_query below = {cone->apex, cone->base, point, cone->apex, 0, false};
    height_query within = {cone->apex, cone->base, point, cone->apex, cone->radius, true};
    return sign_of(&within) >= 0 && sign_of(&below) >= 0;
}

int sure_cone_height_exact(sure_vec3 point, const sure_cone *cone)
{
    return sure_cone_height_certain(point, cone);
}

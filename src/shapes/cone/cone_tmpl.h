/* SPDX-License-Identifier: MIT */
/* The cone over any number (numbers/number.h). With Q the apex, A = base - Q, H = A.A,
 * K = H + r^2, m = o - Q, w = d x m, g = A x w, of a point p seen from Q
 *
 *     F(p) = [p, p],  negative within the double cone
 *     [u, v] = H^2 u.v - K (A.u)(A.v) = H (A x u).(A x v) - r^2 (A.u)(A.v)
 *     F(m + t d) = a t^2 + 2 b t + c:  a = [d, d],  b = [m, d],  c = [m, m]
 *     b^2 - a c = H^2 D,  D = r^2 g.g - H (A.w)^2
 *
 * and half the gradient of F is H^2 p - K (A.p) A. The planes of base and apex are A.p = H and 0;
 * the kept nappe is that of A.p >= 0. */
#include "../../numbers/number.h"

#include <surehit/cone.h>

/* [u, v] by its first form, for any H: u_v = u.v, a_u = A.u, a_v = A.v */
NUMBER_INLINE OVER(two_terms) OVER(cone_form)(number_context *c, number height, number slant,
                                              number u_v, number a_u, number a_v)
{
    return (OVER(two_terms)){number_mul(c, height, number_mul(c, height, u_v)),
                             number_mul(c, slant, number_mul(c, a_u, a_v))};
}

/* By its second, whose terms are near each other only close to the wall: arms = (A x u).(A x v),
 * depths = (A.u)(A.v) */
NUMBER_INLINE OVER(two_terms)
    OVER(cone_body)(number_context *c, number height, number r, number arms, number depths)
{
    return (OVER(two_terms)){number_mul(c, height, arms),
                             number_mul(c, number_square(c, r), depths)};
}

/* Half the gradient of F at p; depth = A.p */
NUMBER_INLINE vector OVER(cone_gradient)(number_context *c, vector axis, number height,
                                         number slant, vector p, number depth)
{
    return vector_sub(c, vector_scale(c, number_square(c, height), p),
                      vector_scale(c, number_mul(c, slant, depth), axis));
}

/* D */
NUMBER_INLINE OVER(two_terms) OVER(cone_discriminant)(number_context *c, vector axis, number height,
                                                      vector d, vector m, number r)
{
    vector w = vector_cross(c, d, m);
    return (OVER(two_terms)){
        number_mul(c, number_square(c, r), vector_square(c, vector_cross(c, axis, w))),
        number_mul(c, height, number_square(c, vector_dot(c, axis, w)))};
}

/* D of a ray. */
NUMBER_APART OVER(two_terms) OVER(cone_discriminant_of)(const sure_ray *ray, const void *shape)
{
    const sure_cone *s = (const sure_cone *)shape;
    number_context c = {0};
    vector axis = vector_between(&c, s->apex, s->base);
    return OVER(cone_discriminant)(&c, axis, vector_square(&c, axis), vector_of(&c, ray->direction),
                                   vector_between(&c, s->apex, ray->origin),
                                   number_of(&c, s->radius));
}

/* Where the line touches the wall, D = 0, A.p is H^2/a times the first of these, and H - A.p is H/a
 * times the second; depth = A.m, speed = A.d */
NUMBER_INLINE OVER(two_terms) OVER(cone_touch)(number_context *c, number a, number height,
                                               number depth, number speed, number m_d, number d_d)
{
    number sunk = number_minor(c, depth, speed, m_d, d_d);
    return (OVER(two_terms)){sunk, number_sub(c, a, number_mul(c, height, sunk))};
}

/* Of a ray. */
NUMBER_APART OVER(two_terms) OVER(cone_touch_of)(const sure_ray *ray, const void *shape)
{
    const sure_cone *s = (const sure_cone *)shape;
    number_context c = {0};
    vector axis = vector_between(&c, s->apex, s->base), d = vector_of(&c, ray->direction);
    vector m = vector_between(&c, s->apex, ray->origin);
    number height = vector_square(&c, axis), speed = vector_dot(&c, axis, d);
    number slant = number_add(&c, height, number_square(&c, number_of(&c, s->radius)));
    number d_d = vector_square(&c, d);
    number a = OVER(difference)(&c, OVER(cone_form)(&c, height, slant, d_d, speed, speed));
    return OVER(cone_touch)(&c, a, height, vector_dot(&c, axis, m), speed, vector_dot(&c, m, d),
                            d_d);
}

/* Half the slope of F along d, at o + x d: a x + b. */
NUMBER_RARE number OVER(cone_slope_at)(const sure_ray *ray, const void *shape, double x)
{
    const sure_cone *s = (const sure_cone *)shape;
    number_context c = {0};
    vector axis = vector_between(&c, s->apex, s->base), d = vector_of(&c, ray->direction);
    vector m = vector_between(&c, s->apex, ray->origin);
    vector p = vector_add(&c, m, vector_scale(&c, number_of(&c, x), d));
    number height = vector_square(&c, axis);
    number slant = number_add(&c, height, number_square(&c, number_of(&c, s->radius)));
    return OVER(difference)(&c, OVER(cone_form)(&c, height, slant, vector_dot(&c, p, d),
                                                vector_dot(&c, axis, p), vector_dot(&c, axis, d)));
}

/* -A.p, A.p - H and F(p): none is positive in the solid. At A.p = 0 the last is not negative, and 0
 * at the apex alone. */
NUMBER_RARE int OVER(cone_sides)(number_context *c, const void *shape, sure_vec3 place,
                                 number of[3])
{
    const sure_cone *s = (const sure_cone *)shape;
    vector axis = vector_between(c, s->apex, s->base), p = vector_between(c, s->apex, place);
    number height = vector_square(c, axis), depth = vector_dot(c, axis, p);
    number arms = vector_square(c, vector_cross(c, axis, p));
    of[0] = number_negate(c, depth);
    of[1] = number_sub(c, depth, height);
    of[2] = OVER(difference)(
        c, OVER(cone_body)(c, height, number_of(c, s->radius), arms, number_square(c, depth)));
    return 3;
}

#undef NUMBER

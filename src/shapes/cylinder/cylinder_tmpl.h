/* SPDX-License-Identifier: MIT */
/* The cylinder over any number (numbers/number.h). With Q the base's centre, A = top - base,
 * H = A.A, m = o - Q, X = A x d, of a point p seen from Q
 *
 *     F(p) = |A x p|^2 - r^2 H,  negative within the wall
 *     [u, v] = (A x u).(A x v) = H u.v - (A.u)(A.v)
 *     F(m + t d) = a t^2 + 2 b t + c:  a = [d, d],  b = [m, d],  c = F(m)
 *     b^2 - a c = H D,  D = r^2 X.X - (X.m)^2,  since X x (A x m) = A (X.m)
 *
 * and half the gradient of F is H p - (A.p) A. The planes of base and top are A.p = 0 and H. */
#include "../../numbers/number.h"

#include <surehit/cylinder.h>

/* [u, v]; u_v = u.v, a_u = A.u, a_v = A.v */
NUMBER_INLINE number OVER(cylinder_form)(number_context *c, number height, number u_v, number a_u,
                                         number a_v)
{
    return number_sub(c, number_mul(c, height, u_v), number_mul(c, a_u, a_v));
}

/* F(p); arms = |A x p|^2 */
NUMBER_INLINE OVER(two_terms)
    OVER(cylinder_body)(number_context *c, number arms, number height, number r)
{
    return (OVER(two_terms)){arms, number_mul(c, number_square(c, r), height)};
}

/* Half the gradient of F at p; depth = A.p */
NUMBER_INLINE vector OVER(cylinder_gradient)(number_context *c, vector axis, number height,
                                             vector p, number depth)
{
    return vector_sub(c, vector_scale(c, height, p), vector_scale(c, depth, axis));
}

/* D; a = X.X, across = X */
NUMBER_INLINE OVER(two_terms)
    OVER(cylinder_discriminant)(number_context *c, number a, vector across, vector m, number r)
{
    return (OVER(two_terms)){number_mul(c, number_square(c, r), a),
                             number_square(c, vector_dot(c, across, m))};
}

/* D of a ray. */
NUMBER_APART OVER(two_terms) OVER(cylinder_discriminant_of)(const sure_ray *ray, const void *shape)
{
    const sure_cylinder *s = (const sure_cylinder *)shape;
    number_context c = {0};
    vector axis = vector_between(&c, s->base, s->top);
    vector across = vector_cross(&c, axis, vector_of(&c, ray->direction));
    return OVER(cylinder_discriminant)(&c, vector_square(&c, across), across,
                                       vector_between(&c, s->base, ray->origin),
                                       number_of(&c, s->radius));
}

/* Where the line touches the wall, D = 0, A.p is H/a times the first of these, and H - A.p that
 * times the second; along = A.m, speed = A.d */
NUMBER_INLINE OVER(two_terms) OVER(cylinder_touch)(number_context *c, number a, number along,
                                                   number speed, number m_d, number d_d)
{
    number sunk = number_minor(c, along, speed, m_d, d_d);
    return (OVER(two_terms)){sunk, number_sub(c, a, sunk)};
}

/* Of a ray. */
NUMBER_APART OVER(two_terms) OVER(cylinder_touch_of)(const sure_ray *ray, const void *shape)
{
    const sure_cylinder *s = (const sure_cylinder *)shape;
    number_context c = {0};
    vector axis = vector_between(&c, s->base, s->top), d = vector_of(&c, ray->direction);
    vector m = vector_between(&c, s->base, ray->origin);
    return OVER(cylinder_touch)(&c, vector_square(&c, vector_cross(&c, axis, d)),
                                vector_dot(&c, axis, m), vector_dot(&c, axis, d),
                                vector_dot(&c, m, d), vector_square(&c, d));
}

/* Half the slope of F along d, at o + x d: a x + b. */
NUMBER_RARE number OVER(cylinder_slope_at)(const sure_ray *ray, const void *shape, double x)
{
    const sure_cylinder *s = (const sure_cylinder *)shape;
    number_context c = {0};
    vector axis = vector_between(&c, s->base, s->top), d = vector_of(&c, ray->direction);
    vector m = vector_between(&c, s->base, ray->origin);
    vector p = vector_add(&c, m, vector_scale(&c, number_of(&c, x), d));
    return OVER(cylinder_form)(&c, vector_square(&c, axis), vector_dot(&c, p, d),
                               vector_dot(&c, axis, p), vector_dot(&c, axis, d));
}

/* -A.p, A.p - H and F(p): none is positive in the solid. */
NUMBER_RARE int OVER(cylinder_sides)(number_context *c, const void *shape, sure_vec3 place,
                                     number of[3])
{
    const sure_cylinder *s = (const sure_cylinder *)shape;
    vector axis = vector_between(c, s->base, s->top), p = vector_between(c, s->base, place);
    number height = vector_square(c, axis), depth = vector_dot(c, axis, p);
    number arms = vector_square(c, vector_cross(c, axis, p));
    of[0] = number_negate(c, depth);
    of[1] = number_sub(c, depth, height);
    of[2] = OVER(difference)(c, OVER(cylinder_body)(c, arms, height, number_of(c, s->radius)));
    return 3;
}

#undef NUMBER

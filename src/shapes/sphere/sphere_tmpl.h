/* SPDX-License-Identifier: MIT */
/* The sphere over any number (numbers/number.h). With m = o - C, of a point p seen from C
 *
 *     F(p) = p.p - r^2,  negative inside; half its gradient is p
 *     F(m + t d) = a t^2 + 2 b t + c:  a = d.d,  b = m.d,  c = F(m)
 *     D = b^2 - a c = r^2 a - |d x m|^2
 *
 * the last by Lagrange's identity: two terms that are near each other only when the ray grazes,
 * while b^2 and a c are whenever m is much longer than r. */
#include "../../numbers/number.h"

#include <surehit/sphere.h>

NUMBER_INLINE OVER(two_terms) OVER(sphere_body)(number_context *c, vector p, number r)
{
    return (OVER(two_terms)){vector_square(c, p), number_square(c, r)};
}

/* D; a = d.d */
NUMBER_INLINE OVER(two_terms)
    OVER(sphere_discriminant)(number_context *c, number a, vector d, vector m, number r)
{
    return (OVER(two_terms)){number_mul(c, a, number_square(c, r)),
                             vector_square(c, vector_cross(c, d, m))};
}

/* D of a ray. */
NUMBER_APART OVER(two_terms) OVER(sphere_discriminant_of)(const sure_ray *ray, const void *shape)
{
    const sure_sphere *s = (const sure_sphere *)shape;
    number_context c = {0};
    vector d = vector_of(&c, ray->direction), m = vector_between(&c, s->centre, ray->origin);
    return OVER(sphere_discriminant)(&c, vector_square(&c, d), d, m, number_of(&c, s->radius));
}

/* Half the slope of F along d, at o + x d: a x + b. */
NUMBER_APART number OVER(sphere_slope_at)(const sure_ray *ray, const void *shape, double x)
{
    const sure_sphere *s = (const sure_sphere *)shape;
    number_context c = {0};
    vector d = vector_of(&c, ray->direction), m = vector_between(&c, s->centre, ray->origin);
    vector p = vector_add(&c, m, vector_scale(&c, number_of(&c, x), d));
    return vector_dot(&c, p, d);
}

/* F */
NUMBER_APART int OVER(sphere_sides)(number_context *c, const void *shape, sure_vec3 p, number of[3])
{
    const sure_sphere *s = (const sure_sphere *)shape;
    vector m = vector_between(c, s->centre, p);
    of[0] = OVER(difference)(c, OVER(sphere_body)(c, m, number_of(c, s->radius)));
    return 1;
}

#undef NUMBER

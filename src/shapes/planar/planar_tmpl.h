/* SPDX-License-Identifier: MIT */
/* Plane and disc over any number (numbers/number.h). With m = o - Q:
 *
 *     h = N.m,  e = N.d,  t = -h / e
 *
 * and a point p is on the side that N.(p - Q) says. The disc holds the crossing when
 *
 *     |e m - h d|^2 <= r^2 e^2
 *
 * A line in the disc's plane is cut by its circle as by the sphere (sphere_tmpl.h). */
#include "../../numbers/number.h"

/* |e m - h d|^2 from r^2 e^2; above 0 inside the rim */
NUMBER_INLINE OVER(two_terms)
    OVER(disc_rim)(number_context *c, number e, number h, vector m, vector d, number r)
{
    vector foot = vector_sub(c, vector_scale(c, e, m), vector_scale(c, h, d));
    return (OVER(two_terms)){number_mul(c, number_square(c, r), number_square(c, e)),
                             vector_square(c, foot)};
}

/* N.(p - Q); the structs of both begin with Q and N. */
NUMBER_RARE int OVER(planar_sides)(number_context *c, const void *shape, sure_vec3 p, number of[3])
{
    const sure_vec3 *s = (const sure_vec3 *)shape;
    of[0] = vector_dot(c, vector_of(c, s[1]), vector_between(c, s[0], p));
    return 1;
}

#undef NUMBER

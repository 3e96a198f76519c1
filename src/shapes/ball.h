/* The stable sphere, for the stems that meet one: the sphere itself and the disc seen edge on. */
#ifndef SHAPES_BALL_H
#define SHAPES_BALL_H

#include "sight.h"

/* |m + t d|^2 = r^2 with w = d x m, |w|/|d| the line's distance from the centre (Lagrange's
 * identity takes the cancellation out of D/4):
 *
 *     a = d.d,  b/2 = m.d,  c = m.m - r^2,  D/4 = r^2 d.d - w.w
 */
static inline void ball_look_hard(const twice_sight *p, sight *s)
{
    twice_vec3 w = twice_cross(&p->d, &p->m);
    twice a = twice_dot(&p->d, &p->d), rr = twice_product(p->r, p->r);
    s->a = twice_rounded(a);
    s->half_b = twice_rounded(twice_dot(&p->m, &p->d));
    s->c = twice_rounded(twice_difference(twice_dot(&p->m, &p->m), rr));
    s->quarter = twice_rounded(twice_difference(twice_product(rr, a), twice_dot(&w, &w)));
    s->factor = 1;
}

#endif

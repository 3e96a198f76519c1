/* The plane stem's formula, for the stems that lie in a plane. */
#ifndef INTERSECT_PLANE_H
#define INTERSECT_PLANE_H

#include "sight.h"
#include "span.h"

/* N.(o + t d - Q) = 0 with rc = Q - o:
 *
 *     t = N.rc / N.d           one point, or for N.d = 0
 *     the whole line when N.rc = 0, nothing otherwise
 */
#ifndef SURE_STABLE
static inline span plane_line_span(vec3 rc, vec3 d, vec3 normal)
{
    real n_rc = vec3_dot(normal, rc);
    real n_d = vec3_dot(normal, d);
    if (n_d == 0)
        return n_rc == 0 ? span_line(SURE_PART_SURFACE, true) : span_empty();
    real t = n_rc / n_d;
    return span_of(t, t, SURE_PART_SURFACE);
}
#else
/* Stable: the same by the origin's height over the plane. */
static inline span plane_sight_span(const sight *s)
{
    if (s->speed == 0)
        return s->over == 0 ? span_line(SURE_PART_SURFACE, true) : span_empty();
    return span_of(-s->over / s->speed, -s->over / s->speed, SURE_PART_SURFACE);
}
#endif

#endif

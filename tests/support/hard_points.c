/* SPDX-License-Identifier: MIT */
#include "hard_points.h"

#include "case.h"
#include "objects.h"

#include <math.h>

bool same_place(sure_vec3 a, sure_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* v / |v|, or zero. */
static sure_vec3 direction(sure_vec3 v)
{
    int exponent;
    (void)frexp(fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z))), &exponent);
    v = (sure_vec3){ldexp(v.x, -exponent), ldexp(v.y, -exponent), ldexp(v.z, -exponent)};
    double length = hypot(hypot(v.x, v.y), v.z);
    return length > 0 ? (sure_vec3){v.x / length, v.y / length, v.z / length} : v;
}

/* Small numbers from the draw's bits. */
static int part_of(uint64_t draw, int at, int below)
{
    return (int)(draw >> at & 0xff) % below;
}

/* No step in three of four draws, else up to 4. */
static double moved(double x, uint64_t draw, int at)
{
    return draw >> 60 < 12 ? x : step_ulps(x, part_of(draw, at, 9) - 4);
}

sure_vec3 hard_point(const sure_object *solid, uint64_t draw)
{
    static const double reach[] = {1, 1, 1, 1, 0.5, 2, 0, 1e-9};
    const sure_cylinder *s = &solid->as.cylinder; /* a cone has its numbers in the same places */
    const sure_vec3 axis = minus(s->top, s->base);
    const sure_vec3 any = {part_of(draw, 0, 201) - 100, part_of(draw, 8, 201) - 100,
                           part_of(draw, 16, 201) - 100};
    sure_vec3 across = direction(cross(direction(axis), any)), p = s->base;
    double radius = s->radius * reach[part_of(draw, 24, 8)];
    int where = part_of(draw, 32, 8);
    if (where == 0 || where == 1)
        p = s->top;
    if (where == 2)
        p = plus(s->base, times(part_of(draw, 40, 21) / 20.0, axis));
    if (where != 0 || !is_pointed(solid))
        p = plus(p, times(radius, across));
    p = (sure_vec3){moved(p.x, draw, 48), moved(p.y, draw, 40), moved(p.z, draw, 56)};
    return isfinite(p.x) && isfinite(p.y) && isfinite(p.z) ? p : s->base;
}

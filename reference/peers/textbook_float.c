/* SPDX-License-Identifier: MIT */
/* Stands for the routine of a first ray tracer, a shader or a game: the books' formulas in single
 * precision, the quadratic by -b and the root of its discriminant b^2 - 4 a c.
 *
 *     E. Haines: Essential Ray Tracing Algorithms. In A. S. Glassner (ed.): An Introduction to Ray
 *     Tracing. Academic Press 1989, 2 (sphere, plane, box)
 *     P. J. Schneider, D. H. Eberly: Geometric Tools for Computer Graphics. Morgan Kaufmann 2003,
 *     11.1 and 11.3 (disc, cylinder, cone)
 *
 *     sphere   d.d t^2 + 2 m.d t + m.m - r^2 = 0,  m = o - C
 *     plane    t = N.(Q - o) / N.d
 *     box      t = (low - o) / d and (high - o) / d of each axis: the last entry, the first exit
 *
 * FROZEN, with what it includes (textbook_bench.h). */
#define PEER_FLOAT
#include "peer.h"
#include "textbook_solids.h"

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

static int solve(real a, real b, real c, real roots[2])
{
    real full_b = 2 * b;
    real discriminant = full_b * full_b - 4 * a * c;
    if (a == 0) {
        roots[0] = roots[1] = -c / full_b;
        return full_b != 0;
    }
    if (discriminant < 0)
        return 0;
    real root = square_root(discriminant);
    roots[0] = (-full_b - root) / (2 * a);
    roots[1] = (-full_b + root) / (2 * a);
    return 1;
}

int PEER(plane)(const real *numbers, const real *plane, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 n = vector(plane + 3);
    real t = dot(n, sub(vector(plane), ray.o)) / dot(n, ray.d);
    return is_in_range(&ray, t) ? found(hit, t, SURE_CANDIDATE_SURFACE) : SURE_CANDIDATE_MISS;
}

int PEER(disc)(const real *numbers, const real *disc, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 n = vector(disc + 3), m = sub(ray.o, vector(disc));
    real t = -dot(n, m) / dot(n, ray.d);
    vec3 p = along(m, t, ray.d);
    if (!is_in_range(&ray, t) || dot(p, p) > disc[6] * disc[6])
        return SURE_CANDIDATE_MISS;
    return found(hit, t, SURE_CANDIDATE_SURFACE);
}

int PEER(sphere)(const real *numbers, const real *sphere, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 m = sub(ray.o, vector(sphere));
    real roots[2];
    if (!solve(dot(ray.d, ray.d), dot(m, ray.d), dot(m, m) - sphere[3] * sphere[3], roots))
        return SURE_CANDIDATE_MISS;
    return found_first(&ray, roots[0], roots[1], hit);
}

int PEER(cylinder)(const real *numbers, const real *cylinder, peer_hit *hit)
{
    return textbook_cylinder(numbers, cylinder, hit);
}

int PEER(cone)(const real *numbers, const real *cone, peer_hit *hit)
{
    return textbook_cone(numbers, cone, hit);
}

typedef struct {
    real t;
    int part;
} face;

/* A slab's two faces: the chord is what all three have in common. 0: nothing. */
static int cut(real o, real d, real low, real high, int part, face *near, face *far)
{
    face first = {(low - o) / d, part}, second = {(high - o) / d, part + 1};
    if (d == 0)
        return o >= low && o <= high;
    if (first.t > second.t) {
        face swapped = first;
        first = second;
        second = swapped;
    }
    if (first.t > near->t)
        *near = first;
    if (second.t < far->t)
        *far = second;
    return near->t <= far->t;
}

int PEER(box)(const real *numbers, const real *box, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 o = ray.o, d = ray.d, low = vector(box), high = vector(box + 3);
    face near = {-(real)INFINITY, 0}, far = {(real)INFINITY, 0};
    if (!cut(o.x, d.x, low.x, high.x, SURE_CANDIDATE_X_MIN, &near, &far) ||
        !cut(o.y, d.y, low.y, high.y, SURE_CANDIDATE_Y_MIN, &near, &far) ||
        !cut(o.z, d.z, low.z, high.z, SURE_CANDIDATE_Z_MIN, &near, &far))
        return SURE_CANDIDATE_MISS;
    const face *first = is_in_range(&ray, near.t) ? &near : &far;
    return is_in_range(&ray, first->t) ? found(hit, first->t, first->part) : SURE_CANDIDATE_MISS;
}

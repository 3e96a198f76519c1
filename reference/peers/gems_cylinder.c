/* SPDX-License-Identifier: MIT */
/* Stands for the capped cylinder of the Graphics Gems, which many programs have: the closest points
 * of line and axis by vector products, half the chord from there, clipped by the end planes.
 *
 *     J. M. Cychosz, W. N. Waggenspack: Intersecting a Ray with a Cylinder. In P. S. Heckbert
 *     (ed.): Graphics Gems IV. Academic Press 1994, pp. 356-365
 *
 *     m = o - base,  n = d x A / |d x A|,  distance = |m.n|
 *     t = -(m x A).n / |d x A|,  s = |sqrt(r^2 - distance^2) / d.(n x A)|,  t -+ s */
#include "peer.h"

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

typedef struct {
    real enter, leave;
    int enter_part, leave_part;
} chord;

/* The chord of the infinite cylinder; 0 for none. The vectors are rounded, and lines that are
 * parallel up to rounding pass for ones that are not. */
static int wall_chord(vec3 m, vec3 d, vec3 axis, real r, chord *cut)
{
    vec3 across = cross(d, axis);
    real length = square_root(dot(across, across));
    if (length == 0) {
        vec3 aside = along(m, -dot(m, axis), axis);
        *cut = (chord){-(real)INFINITY, (real)INFINITY, SURE_CANDIDATE_WALL, SURE_CANDIDATE_WALL};
        return square_root(dot(aside, aside)) <= r;
    }
    vec3 n = scaled(1 / length, across);
    real distance = size_of(dot(m, n));
    if (!(distance <= r))
        return 0;
    real t = -dot(cross(m, axis), n) / length;
    vec3 out = cross(n, axis);
    out = scaled(1 / square_root(dot(out, out)), out);
    real s = size_of(square_root(r * r - distance * distance) / dot(d, out));
    *cut = (chord){t - s, t + s, SURE_CANDIDATE_WALL, SURE_CANDIDATE_WALL};
    return 1;
}

/* What is between the end planes; 0 for nothing. */
static int clip(chord *cut, real height, real climb, real h)
{
    if (climb == 0)
        return height >= 0 && height <= h;
    int up = climb > 0;
    real first = (up ? -height : h - height) / climb, last = (up ? h - height : -height) / climb;
    if (first > cut->enter) {
        cut->enter = first;
        cut->enter_part = up ? SURE_CANDIDATE_BASE : SURE_CANDIDATE_TOP;
    }
    if (last < cut->leave) {
        cut->leave = last;
        cut->leave_part = up ? SURE_CANDIDATE_TOP : SURE_CANDIDATE_BASE;
    }
    return cut->enter <= cut->leave;
}

int PEER(cylinder)(const real *numbers, const real *cylinder, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 base = vector(cylinder), n = sub(vector(cylinder + 3), base), m = sub(ray.o, base);
    real h = square_root(dot(n, n));
    vec3 axis = scaled(1 / h, n);
    chord cut;
    if (!wall_chord(m, ray.d, axis, cylinder[6], &cut) ||
        !clip(&cut, dot(m, axis), dot(ray.d, axis), h))
        return SURE_CANDIDATE_MISS;
    if (is_in_range(&ray, cut.enter))
        return found(hit, cut.enter, cut.enter_part);
    if (is_in_range(&ray, cut.leave))
        return found(hit, cut.leave, cut.leave_part);
    return SURE_CANDIDATE_MISS;
}

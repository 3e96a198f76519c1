/* SPDX-License-Identifier: MIT */
/* Stands for the sphere of careful renderers, in single precision (with -DPEER_FLOAT) and double:
 * the discriminant from the line's distance to the centre, as a vector, which keeps far and large
 * spheres from cancelling, and the second root by Vieta.
 *
 *     E. Haines, J. Guenther, T. Akenine-Moeller: Precision Improvements for Ray/Sphere
 *     Intersection. In E. Haines, T. Akenine-Moeller (eds.): Ray Tracing Gems. Apress 2019, 7,
 *     https://www.realtimerendering.com/raytracinggems/
 *
 *     f = o - C,  b = -f.d,  D = r^2 - |f + (b / d.d) d|^2
 *     q = b + sign(b) sqrt(d.d D),  c = f.f - r^2,  t = c / q, q / d.d */
#include "peer.h"

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

int PEER(sphere)(const real *numbers, const real *sphere, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 f = sub(ray.o, vector(sphere));
    real r = sphere[3], a = dot(ray.d, ray.d), b = -dot(f, ray.d);
    vec3 foot = along(f, b / a, ray.d);
    real discriminant = r * r - dot(foot, foot);
    if (discriminant < 0)
        return SURE_CANDIDATE_MISS;
    real root = square_root(a * discriminant);
    real q = b < 0 ? b - root : b + root;
    real from_q = q / a, by_vieta = q == 0 ? from_q : (dot(f, f) - r * r) / q;
    return b < 0 ? found_first(&ray, from_q, by_vieta, hit)
                 : found_first(&ray, by_vieta, from_q, hit);
}

/* SPDX-License-Identifier: MIT */
/* Imath, the vectors of OpenEXR and of the film industry: Sphere3 and Plane3::intersectT
 * (https://imath.readthedocs.io/en/latest/classes/Sphere3.html, .../Plane3.html).
 *
 *     unit   a Line3 keeps a direction of length 1
 *     ray    "the smallest t with t>=0"; of a plane it is that of the whole line
 *     scale  squares of lengths neither overflow nor underflow */
#include "library.h"

#include <ImathPlane.h>
#include <ImathSphere.h>

const char sure_candidate_entry[] = "unit ray scale=1e-3..1e6";

using vector = Imath::Vec3<real>;

template <class Surface> static int answer(const Surface &surface, const real *ray, peer_hit *hit)
{
    Imath::Line3<real> line;
    line.pos = vector(ray[0], ray[1], ray[2]);
    line.dir = vector(ray[3], ray[4], ray[5]);
    real t;
    return surface.intersectT(line, t) ? found_at(ray, t, hit) : SURE_CANDIDATE_MISS;
}

int PEER(plane)(const real *ray, const real *plane, peer_hit *hit)
{
    vector point(plane[0], plane[1], plane[2]), normal(plane[3], plane[4], plane[5]);
    return answer(Imath::Plane3<real>(point, normal), ray, hit);
}

int PEER(sphere)(const real *ray, const real *sphere, peer_hit *hit)
{
    vector centre(sphere[0], sphere[1], sphere[2]);
    return answer(Imath::Sphere3<real>(centre, sphere[3]), ray, hit);
}

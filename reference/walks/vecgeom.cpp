/* SPDX-License-Identifier: MIT */
/* VecGeom's solids as programs of particle transport ask them: DistanceToOut of who is inside,
 * DistanceToIn of who is not. A tracker knows which it is; here it is told by Inside, and in the
 * surface, which has a thickness (kTolerance), by where one goes: who goes in has just come in. */
#include <cmath>

#include <VecGeom/base/Global.h>
#include <VecGeom/volumes/Box.h>
#include <VecGeom/volumes/Cone.h>
#include <VecGeom/volumes/Orb.h>
#include <VecGeom/volumes/Tube.h>

#include <surehit/candidate.h>

using namespace vecgeom;

const int sure_candidate_version = SURE_CANDIDATE_VERSION;
const char sure_candidate_entry[] = "unit centred ray";

static int walk(const VUnplacedVolume &solid, const double *ray, sure_candidate_hit *hit)
{
    const Vector3D<double> from(ray[0], ray[1], ray[2]), way(ray[3], ray[4], ray[5]);
    Vector3D<double> normal;
    const EnumInside at = solid.Inside(from);
    bool is_in = at == kInside;
    if (at == kSurface) {
        (void)solid.Normal(from, normal); /* false, but right, in a cone's wider surface */
        is_in = normal.Dot(way) < 0;
    }
    double t = is_in ? solid.DistanceToOut(from, way) : solid.DistanceToIn(from, way);
    if (!(t < kInfLength))
        return SURE_CANDIDATE_MISS;
    hit->t = t > 0 ? t : 0;
    return SURE_CANDIDATE_HIT;
}

int sure_candidate_sphere(const double *ray, const double *n, sure_candidate_hit *hit)
{
    return walk(UnplacedOrb(n[3]), ray, hit);
}

int sure_candidate_cylinder(const double *ray, const double *n, sure_candidate_hit *hit)
{
    return walk(GenericUnplacedTube(0, n[6], n[5], 0, kTwoPi), ray, hit);
}

int sure_candidate_cone(const double *ray, const double *n, sure_candidate_hit *hit)
{
    return walk(GenericUnplacedCone(0, n[6], 0, 0, n[5], 0, kTwoPi), ray, hit);
}

int sure_candidate_box(const double *ray, const double *n, sure_candidate_hit *hit)
{
    return walk(UnplacedBox(n[3], n[4], n[5]), ray, hit);
}

/* SPDX-License-Identifier: MIT */
/* VecGeom, the solids of Geant4 and of particle transport: DistanceToIn and -Out of a
 * VUnplacedVolume (https://gitlab.cern.ch/VecGeom/VecGeom, VecGeom/volumes/UnplacedVolume.h).
 *
 *     unit      "along the normalized direction dir"
 *     centred   solids have their middle in the origin, their axis is z
 *     ray       "from an outside space point" or "an internal or surface" one: there is no end
 *     scale     "the surface is defined by a thickness constant", an absolute length of 1e-9 */
#include "library.h"

#include <VecGeom/volumes/Box.h>
#include <VecGeom/volumes/Cone.h>
#include <VecGeom/volumes/Orb.h>
#include <VecGeom/volumes/Tube.h>

const char sure_candidate_entry[] = "unit centred ray scale=1e-2..1e6";

using namespace vecgeom;

struct solid {
    std::unique_ptr<VUnplacedVolume> of;
    explicit solid(VUnplacedVolume *made) : of(made)
    {
    }
    int meet(const real *ray, peer_hit *hit) const
    {
        const Vector3D<double> from(ray[0], ray[1], ray[2]), way(ray[3], ray[4], ray[5]);
        double t = of->Inside(from) == kOutside ? of->DistanceToIn(from, way)
                                                : of->DistanceToOut(from, way);
        return found_at(ray, t < kInfLength ? t : NAN, hit);
    }
};
ANSWER_BY(sphere, solid, new UnplacedOrb(n[3]))
ANSWER_BY(cylinder, solid, new GenericUnplacedTube(0, n[6], n[5], 0, kTwoPi))
ANSWER_BY(cone, solid, new GenericUnplacedCone(0, n[6], 0, 0, n[5], 0, kTwoPi))
ANSWER_BY(box, solid, new UnplacedBox(n[3], n[4], n[5]))

/* SPDX-License-Identifier: MIT */
/* Simbody, the multibody dynamics of OpenSim: ContactGeometry::intersectsRay
 * (https://simbody.github.io/simbody-3.6-doxygen/api/classSimTK_1_1ContactGeometry.html).
 *
 *     unit      the direction is a UnitVec3
 *     centred   shapes have their middle in the origin; a half-space is all x > 0
 *     ray       "the distance from the ray origin to the intersection point"
 *     scale     squares of lengths neither overflow nor underflow */
#include "library.h"

#include <simmath/internal/ContactGeometry.h>

const char sure_candidate_entry[] = "unit centred ray scale=1e-3..1e6";

using SimTK::ContactGeometry;
using SimTK::UnitVec3;
using SimTK::Vec3;

struct geometry {
    ContactGeometry of;
    int meet(const real *ray, peer_hit *hit) const
    {
        /* Turned, so that a plane's normal (0, 0, 1) is the half-space's (-1, 0, 0). */
        const Vec3 from(-ray[2], ray[1], ray[0]), way(-ray[5], ray[4], ray[3]);
        real t;
        UnitVec3 normal;
        return found_at(ray, of.intersectsRay(from, UnitVec3(way, true), t, normal) ? t : NAN, hit);
    }
};

ANSWER_BY(plane, geometry, ContactGeometry::HalfSpace())
ANSWER_BY(sphere, geometry, ContactGeometry::Sphere(n[3]))

/* SPDX-License-Identifier: MIT */
/* ODE, the Open Dynamics Engine: dCollide of a ray and a geom, as its manual has it
 * (https://ode.org/wiki/index.php/Manual, "Collision Detection", "Ray Class").
 *
 *     unit, segment  a ray has a length; depth is "the distance from the start of the ray"
 *     centred        a geom's position is its middle, a cylinder's axis is z
 *     surface=miss   a cylinder's surface at the start is none; the manual does not say
 *     scale          squares of lengths neither overflow nor underflow */
#include "library.h"

#include <ode/ode.h>

const char sure_candidate_entry[] = "unit centred segment surface=miss scale=1e-3..1e6";

static const int started = dInitODE2(0);

struct geom {
    dGeomID of;
    explicit geom(dGeomID made) : of(made)
    {
    }
    geom(const geom &) = delete;
    ~geom()
    {
        dGeomDestroy(of);
    }
    int meet(const real *ray, peer_hit *hit) const
    {
        static const geom asked(dCreateRay(nullptr, 1));
        dContactGeom contact;
        dGeomRaySetLength(asked.of, ray[7]);
        dGeomRaySet(asked.of, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5]);
        bool meets = dCollide(asked.of, of, 1, &contact, sizeof contact) > 0;
        return meets ? found_at(ray, contact.depth, hit) : SURE_CANDIDATE_MISS;
    }
};

ANSWER_BY(plane, geom, dCreatePlane(nullptr, 0, 0, 1, 0))
ANSWER_BY(sphere, geom, dCreateSphere(nullptr, n[3]))
ANSWER_BY(cylinder, geom, dCreateCylinder(nullptr, n[6], 2 * n[5]))
ANSWER_BY(box, geom, dCreateBox(nullptr, 2 * n[3], 2 * n[4], 2 * n[5]))

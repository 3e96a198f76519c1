/* SPDX-License-Identifier: MIT */
/* Bullet: btCollisionWorld::rayTestSingle of a shape, as rayTest calls it
 * (https://pybullet.org/Bullet/BulletFull/classbtCollisionWorld.html). Variants: PEER_GJK, for the
 * usual cast is "approximate but faster"; PEER_MARGIN in the place of the usual one, of 0.04.
 *
 *     unit, segment  from a point to a point; t is the hit fraction, end=miss: less than 1
 *     centred        shapes are "centered around the origin", here with the axis along z
 *     inside=miss, surface=miss   a convex cast moves two bodies that are apart at the start
 *     scale          "minimum object size ... about 0.2 units" (manual, chapter 13) */
#include "library.h"

#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>

const char sure_candidate_entry[] =
    "unit centred segment inside=miss surface=miss end=miss scale=0.2..1000";

struct body {
    std::unique_ptr<btConvexShape> shape;
    int meet(const real *ray, peer_hit *hit) const
    {
        btVector3 from(ray[0], ray[1], ray[2]),
            to = from + ray[7] * btVector3(ray[3], ray[4], ray[5]);
        const btQuaternion unturned = btQuaternion::getIdentity();
        btTransform start(unturned, from), end(unturned, to), nowhere(unturned);
        btCollisionWorld::ClosestRayResultCallback first(from, to);
#ifdef PEER_GJK
        first.m_flags |= btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
#endif
#ifdef PEER_MARGIN
        shape->setMargin(PEER_MARGIN);
#endif
        btCollisionObject object;
        btCollisionWorld::rayTestSingle(start, end, &object, shape.get(), nowhere, first);
        return found_at(ray, first.hasHit() ? first.m_closestHitFraction * ray[7] : NAN, hit);
    }
};
ANSWER_BY(sphere, body, std::make_unique<btSphereShape>(n[3]))
ANSWER_BY(cylinder, body, std::make_unique<btCylinderShapeZ>(btVector3(n[6], n[6], n[5])))
ANSWER_BY(cone, body, std::make_unique<btConeShapeZ>(n[6], 2 * n[5]))
ANSWER_BY(box, body, std::make_unique<btBoxShape>(btVector3(n[3], n[4], n[5])))

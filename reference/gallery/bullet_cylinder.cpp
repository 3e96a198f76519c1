// SPDX-License-Identifier: MIT
// Rays that start above a cylinder's top, by 1 % and 10 % of its half height, and rise.
#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <cstdio>
#include <random>
int main()
{
    std::uniform_real_distribution<btScalar> any(-1, 1);
    for (btScalar size : {1, 5, 10, 100}) {
        int hits[2] = {};
        std::mt19937 random(1);
        btCylinderShape cylinder(size * btVector3(0.2038f, 0.0306f, 0.2038f));
        for (int i = 0; i < 200000; i++) {
            btVector3 from(-2, (i % 2 ? 1.1f : 1.01f) * 0.0306f, any(random) * 0.2038f);
            btVector3 to = from + btVector3(10, std::abs(any(random)), 0);
            btTransform start(btMatrix3x3::getIdentity(), from *= size), nowhere(start), end(start);
            nowhere.setIdentity(), end.setOrigin(to *= size);
            btCollisionWorld::ClosestRayResultCallback hit(from, to);
            hit.m_flags = CAST;
            btCollisionObject object;
            btCollisionWorld::rayTestSingle(start, end, &object, &cylinder, nowhere, hit);
            hits[i % 2] += hit.hasHit();
        }
        printf("half height %6.4f: expected 0 and 0 of 100000 to hit, got %d and %d\n",
               size * 0.0306, hits[0], hits[1]);
    }
}

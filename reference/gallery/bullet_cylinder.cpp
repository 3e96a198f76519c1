// SPDX-License-Identifier: MIT
// Rays that rise from above a cylinder of size argv[1], by argv[2] times its half height.
#include <btBulletCollisionCommon.h>
#include <cstdio>
int main(int, char **argv)
{
    int hits = 0;
    btScalar size = atof(argv[1]), above = 1 + atof(argv[2]);
    btCylinderShape cylinder(size * btVector3(0.2038f, 0.0306f, 0.2038f));
    for (int i = 0; i < 100000; i++) {
        btVector3 from(-2, above * 0.0306f, 0.2038f * (2 * drand48() - 1)), rise(10, drand48(), 0);
        btTransform nowhere(btMatrix3x3::getIdentity()), start(nowhere), end(nowhere);
        start.setOrigin(size * from), end.setOrigin(size * (from + rise));
        btCollisionWorld::ClosestRayResultCallback hit(start.getOrigin(), end.getOrigin());
        hit.m_flags = CAST;
        btCollisionObject object;
        btCollisionWorld::rayTestSingle(start, end, &object, &cylinder, nowhere, hit);
        hits += hit.hasHit();
    }
    printf("%s, above by %s: expected 0 of 100000 to hit, got %d\n", argv[1], argv[2], hits);
}

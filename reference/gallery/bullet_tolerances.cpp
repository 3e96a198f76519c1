// SPDX-License-Identifier: MIT
// Rays that start 10 % of its half height above a cylinder's top, and rise; with both tolerances.
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <btBulletCollisionCommon.h>
int main(int, char **argv)
{
    int hits = 0;
    for (int i = 0; i < 100000; i++) {
        btVector3 from(-2, 1.1f * 0.0306f, 0.2038f * (2 * drand48() - 1)), rise(10, drand48(), 0);
        btTransform nowhere(btMatrix3x3::getIdentity()), start(nowhere), end(nowhere);
        start.setOrigin(from), end.setOrigin(from + rise);
        btSphereShape point(0);
        btCylinderShape cylinder(btVector3(0.2038f, 0.0306f, 0.2038f));
        btVoronoiSimplexSolver solver;
        btConvexCast::CastResult result;
        solver.setEqualVertexThreshold(result.m_subSimplexCastEpsilon = atof(argv[1]));
        btSubsimplexConvexCast cast(&point, &cylinder, &solver);
        hits += cast.calcTimeOfImpact(start, end, nowhere, nowhere, result);
    }
    printf("tolerances %s: expected 0 of 100000 to hit, got %d\n", argv[1], hits);
}

// SPDX-License-Identifier: MIT
// Rays that start 10 % of its half height above a cylinder's top, and rise; with both tolerances.
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <btBulletCollisionCommon.h>
#include <cstdio>
#include <random>
int main()
{
    std::uniform_real_distribution<btScalar> any(-1, 1);
    for (btScalar tolerance : {1e-4, 1e-6, 1e-12}) {
        int hits = 0;
        std::mt19937 random(1);
        for (int i = 0; i < 100000; i++) {
            btVector3 from(-2, 1.1f * 0.0306f, any(random) * 0.2038f);
            btVector3 to = from + btVector3(10, std::abs(any(random)), 0);
            btTransform start(btMatrix3x3::getIdentity(), from), end(start.getBasis(), to);
            btTransform nowhere = btTransform::getIdentity();
            btSphereShape point(0);
            btCylinderShape cylinder(btVector3(0.2038f, 0.0306f, 0.2038f));
            btVoronoiSimplexSolver solver;
            solver.setEqualVertexThreshold(tolerance);
            btConvexCast::CastResult result;
            result.m_subSimplexCastEpsilon = tolerance;
            btSubsimplexConvexCast cast(&point, &cylinder, &solver);
            hits += cast.calcTimeOfImpact(start, end, nowhere, nowhere, result);
        }
        printf("tolerances %g: expected 0 of 100000 to hit, got %d\n", tolerance, hits);
    }
}

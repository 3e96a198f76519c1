// SPDX-License-Identifier: MIT
// A ray across the axis of a cone of length 2, whose radius is 1 at z = -1 and `tip` at z = 1.
#include <VecGeom/base/Global.h>
#include <VecGeom/management/GeoManager.h>
#include <VecGeom/volumes/UnplacedCone.h>
#include <cstdio>
int main()
{
    printf("kTolerance %g, kConeTolerance %g\n", vecgeom::kTolerance, vecgeom::kConeTolerance);
    for (double tip : {0.25, 0.0})
        for (double z : {-0.5, 0.0, 0.5}) {
            auto *cone = vecgeom::GeoManager::MakeInstance<vecgeom::UnplacedCone>(
                0, 1, 0, tip, 1, 0, vecgeom::kTwoPi);
            vecgeom::Vector3D<double> start(-10, 0, z), along(1, 0, 0);
            double right = 10 - (1 - z) / 2 - tip * (1 + z) / 2;
            double t = cone->DistanceToIn(start, along, vecgeom::kInfLength);
            printf("tip %.2f, z %4.1f: expected %.5f, got %.1e less\n", tip, z, right, right - t);
        }
}

// SPDX-License-Identifier: MIT
// Tracks that start beside the tip of a cone, and leave it: s on, they are s from the axis at
// least, where the cone's radius is s / 200.
#include <VecGeom/base/Global.h>
#include <VecGeom/volumes/Cone.h>
#include <cstdio>
int main()
{
    vecgeom::GenericUnplacedCone cone(0, 1, 0, 0, 1, 0, vecgeom::kTwoPi);
    vecgeom::Vector3D<double> along(0, 1, -0.01);
    for (double away : {1e-6, 1e-5, 1e-4}) {
        vecgeom::Vector3D<double> start(away, 0, 1);
        bool outside = cone.Inside(start) == vecgeom::kOutside;
        double t = cone.DistanceToIn(start, along.Unit(), vecgeom::kInfLength);
        printf("%.0e from the tip, %s: expected a miss, got %s\n", away,
               outside ? "outside" : "on the surface", t == 0 ? "0" : "a miss");
    }
}

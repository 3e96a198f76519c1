// SPDX-License-Identifier: MIT
// Rays into a tube of radius and half length 1, aimed at the edge of its end: they cross it whole.
#include <VecGeom/base/Global.h>
#include <VecGeom/volumes/Tube.h>
#include <cmath>
#include <cstdio>
int main()
{
    vecgeom::GenericUnplacedTube tube(0, 1, 1, 0, vecgeom::kTwoPi);
    for (double slope : {0.001, 0.01, 0.1, 0.5}) {
        int missed = 0;
        for (int i = 0; i < 100000; i++) {
            vecgeom::Vector3D<double> edge(cos(i), sin(i), -1);
            vecgeom::Vector3D<double> along(-slope * cos(i), -slope * sin(i), 1);
            vecgeom::Vector3D<double> start = edge - (1 + i % 100) * along;
            missed += tube.DistanceToIn(start, along.Unit(), vecgeom::kInfLength) > 1000;
        }
        printf("slope %5.3f: expected 0 of 100000 missed, got %d\n", slope, missed);
    }
}

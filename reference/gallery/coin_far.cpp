// SPDX-License-Identifier: MIT
// Rays that pass a sphere of radius 1 clear of its rim, by 1 % or more, from farther and farther:
// picked, and of SbSphere by two points of the line that are as far from each other.
#include <Inventor/SbLine.h>
#include <Inventor/SbSphere.h>
#include <Inventor/SbVec3d.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/nodes/SoSphere.h>
#include <cstdio>
#include <random>
int main()
{
    SoDB::init();
    SoSphere *sphere = new SoSphere;
    sphere->ref();
    std::uniform_real_distribution<float> any(-1, 1);
    for (float away = 1e2; away < 1e6; away *= 10) {
        std::mt19937 random(1);
        int asked = 0, picked = 0, by_points = 0;
        while (asked < 10000) {
            SbVec3f o{any(random), any(random), any(random)}, at(0, 0, 0);
            SbVec3f d{any(random), any(random), any(random)};
            o *= away / o.length(), (d -= o).normalize();
            SbVec3d p(o), along(d);
            double off = (p - p.dot(along) / along.dot(along) * along).length();
            SoRayPickAction pick(SbViewportRegion(1, 1));
            pick.setRay(o, d), pick.apply(sphere);
            if (std::abs(off - 1) > 0.01 && ++asked) {
                picked += !pick.getPickedPoint() != (off > 1);
                by_points += SbSphere(at, 1).intersect(SbLine(o, o + away * d), at) != (off < 1);
            }
        }
        printf("%.0e radii: expected 0 of 10000 wrong, got %d; %d\n", away, picked, by_points);
    }
}

// SPDX-License-Identifier: MIT
// Rays along x at a cone of radius 1 and height 2, clear of its outline by 2 %, from ever farther.
#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/nodes/SoCone.h>
#include <cstdio>
#include <random>
int main()
{
    SoDB::init();
    SoCone *cone = new SoCone;
    cone->ref();
    std::uniform_real_distribution<float> any(-1, 1);
    for (float away = 10; away < 1e6; away *= 10) {
        std::mt19937 random(1);
        int wrong = 0;
        for (int asked = 0; asked < 10000;) {
            float y = any(random), z = any(random), over = std::abs(z) - (1 - y) / 2;
            SoRayPickAction pick(SbViewportRegion(1, 1));
            pick.setRay(SbVec3f(-away, y, z), SbVec3f(1, 0, 0));
            pick.apply(cone);
            wrong += std::abs(over) > 0.02 && ++asked && !pick.getPickedPoint() != (over > 0);
        }
        printf("%.0e radii away: expected 0 of 10000 wrong, got %d\n", away, wrong);
    }
}

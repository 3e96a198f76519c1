// SPDX-License-Identifier: MIT
// Rays along x at a cone of radius 1 and height 2, clear of its outline by 2 %, from argv[1] away.
#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoActions.h>
#include <Inventor/nodes/SoCone.h>
int main(int, char **argv)
{
    SoDB::init();
    int wrong = 0;
    for (int asked = 0; asked < 10000;) {
        float y = 2 * drand48() - 1, z = 2 * drand48() - 1, over = std::abs(z) - (1 - y) / 2;
        SoRayPickAction pick(SbViewportRegion(1, 1));
        pick.setRay(SbVec3f(-atof(argv[1]), y, z), SbVec3f(1, 0, 0)), pick.apply(new SoCone);
        wrong += std::abs(over) > 0.02 && ++asked && !pick.getPickedPoint() != (over > 0);
    }
    printf("%s radii away: expected 0 of 10000 wrong, got %d\n", argv[1], wrong);
}

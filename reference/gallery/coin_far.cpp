// SPDX-License-Identifier: MIT
// Rays that pass a sphere of radius 1 clear of its rim, by 1 % or more, from argv[1] away.
#include <Inventor/SbVec3d.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoActions.h>
#include <Inventor/nodes/SoSphere.h>
int main(int, char **argv)
{
    SoDB::init();
    int asked = 0, wrong = 0;
    for (int i = 0; asked < 10000; i++) {
        SbVec3f o(sin(i), cos(i), cos(3 * i)), d(cos(5 * i), sin(7 * i), cos(11 * i));
        d -= o *= atof(argv[1]), d.normalize();
        double off = SbVec3d(o).cross(SbVec3d(d)).length() / SbVec3d(d).length();
        SoRayPickAction pick(SbViewportRegion(1, 1));
        pick.setRay(o, d), pick.apply(new SoSphere);
        wrong += std::abs(off - 1) > 0.01 && ++asked && !pick.getPickedPoint() != (off > 1);
    }
    printf("%s radii: expected 0 of 10000 wrong, got %d\n", argv[1], wrong);
}

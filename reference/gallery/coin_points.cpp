// SPDX-License-Identifier: MIT
// The same rays, each as a line by two points that are as far from each other as from the sphere.
#include <Inventor/SbLine.h>
#include <Inventor/SbSphere.h>
#include <Inventor/SbVec3d.h>
#include <cstdio>
int main(int, char **argv)
{
    int asked = 0, wrong = 0;
    for (int i = 0; asked < 10000; i++) {
        SbVec3f o(sin(i), cos(i), cos(3 * i)), d(cos(5 * i), sin(7 * i), cos(11 * i)), at(0, 0, 0);
        d -= o *= atof(argv[1]);
        double off = SbVec3d(o).cross(SbVec3d(d)).length() / SbVec3d(d).length();
        if (std::abs(off - 1) > 0.01 && ++asked)
            wrong += SbSphere(at, 1).intersect(SbLine(o, o + d), at) != (off < 1);
    }
    printf("%s radii: expected 0 of 10000 wrong, got %d\n", argv[1], wrong);
}

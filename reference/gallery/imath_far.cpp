// SPDX-License-Identifier: MIT
// Rays that pass a sphere of radius 1 clear of its rim, by 1 % or more, from farther and farther.
#include <Imath/ImathSphere.h>
#include <cstdio>
#include <random>
using V = Imath::Vec3<REAL>;
using Exact = Imath::Vec3<long double>;
int main()
{
    std::uniform_real_distribution<REAL> any(-1, 1);
    Imath::Sphere3<REAL> sphere(V(0, 0, 0), 1);
    for (REAL away = 1e2; away < 1e10; away *= 10) {
        std::mt19937 random(1);
        int wrong = 0;
        for (int asked = 0; asked < 10000;) {
            V o = away * V{any(random), any(random), any(random)}.normalized();
            Imath::Line3<REAL> line(o, V{any(random), any(random), any(random)});
            REAL t, off = (Exact(o) % Exact(line.dir)).length() / Exact(line.dir).length();
            if (std::abs(off - 1) > 0.01 && ++asked)
                wrong += sphere.intersectT(line, t) != (off < 1);
        }
        printf("%.0e radii away: expected 0 of 10000 wrong, got %d\n", away, wrong);
    }
}

// SPDX-License-Identifier: MIT
// Rays that pass a sphere of radius 1 clear of its rim, by 1 % or more, from farther and farther.
#include <Imath/ImathSphere.h>
#include <cstdio>
int main()
{
    for (REAL t, away = 1e2; away < 1e10; away *= 10) {
        int asked = 0, wrong = 0;
        for (int i = 0; asked < 10000; i++) {
            Imath::Vec3<REAL> o(sin(i), cos(i), cos(3 * i)), at(0, 0, 0);
            Imath::Vec3<REAL> aim(cos(5 * i), sin(7 * i), cos(11 * i));
            Imath::Line3<REAL> line(o * away, aim);
            Imath::Vec3<long double> start(line.pos), along(line.dir);
            double off = (start % along).length() / along.length();
            if (std::abs(off - 1) > 0.01 && ++asked)
                wrong += Imath::Sphere3<REAL>(at, 1).intersectT(line, t) != (off < 1);
        }
        printf("%.0e radii away: expected 0 of 10000 wrong, got %d\n", away, wrong);
    }
}

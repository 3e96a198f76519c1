// SPDX-License-Identifier: MIT
// Rays that pass a sphere of radius 1 clear of its rim, by 1 % or more, from farther and farther.
#define GLM_ENABLE_EXPERIMENTAL
#include <cstdio>
#include <glm/gtx/intersect.hpp>
#include <random>
using V = glm::vec<3, REAL>;
using Exact = glm::vec<3, long double>;
int main()
{
    std::uniform_real_distribution<REAL> any(-1, 1);
    for (REAL away = 1e2; away < 1e10; away *= 10) {
        std::mt19937 random(1);
        int wrong = 0;
        for (int asked = 0; asked < 10000;) {
            V o = away * normalize(V{any(random), any(random), any(random)});
            V d = normalize(V{any(random), any(random), any(random)} - o);
            REAL t, off = length(cross(Exact(o), Exact(d))) / length(Exact(d));
            if (std::abs(off - 1) > 0.01 && ++asked)
                wrong += glm::intersectRaySphere(o, d, V(0), REAL(1), t) != (off < 1);
        }
        printf("%.0e radii away: expected 0 of 10000 wrong, got %d\n", away, wrong);
    }
}

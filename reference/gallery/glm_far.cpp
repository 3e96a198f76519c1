// SPDX-License-Identifier: MIT
// Rays that pass a sphere of radius 1 clear of its rim, by 1 % or more, from farther and farther.
#define GLM_ENABLE_EXPERIMENTAL
#include <cstdio>
#include <glm/gtc/random.hpp>
#include <glm/gtx/intersect.hpp>
int main()
{
    for (REAL t, away = 1e2; away < 1e10; away *= 10) {
        int asked = 0, wrong = 0;
        while (asked < 10000) {
            auto o = away * glm::sphericalRand(REAL(1));
            auto d = normalize(glm::ballRand(REAL(2)) - o);
            double off = length(cross(glm::dvec3(o), glm::dvec3(d))) / length(glm::dvec3(d));
            if (std::abs(off - 1) > 0.01 && ++asked)
                wrong += glm::intersectRaySphere(o, d, o - o, REAL(1), t) != (off < 1);
        }
        printf("%.0e radii away: expected 0 of 10000 wrong, got %d\n", away, wrong);
    }
}

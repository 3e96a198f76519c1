// SPDX-License-Identifier: MIT
// A ray from (9000, 4000, 0) to the centre of a sphere of radius 1.
#define GLM_ENABLE_EXPERIMENTAL
#include <cstdio>
#include <glm/gtx/intersect.hpp>
int main()
{
    glm::vec3 start(9000, 4000, 0), centre(0);
    float t = 0;
    bool hit = glm::intersectRaySphere(start, normalize(centre - start), centre, 1.0f, t);
    printf("expected a hit, got %s\n", hit ? "a hit" : "a miss");
}

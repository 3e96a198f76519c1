/* SPDX-License-Identifier: MIT */
/* GLM, the mathematics of many OpenGL programs: glm/gtx/intersect.hpp, as its comments have it
 * (https://glm.g-truc.net/0.9.9/api/a00662.html).
 *
 *     unit, aligned   "Ray direction and plane normal must be unit length."
 *     square          the sphere's radius is handed over as its square
 *     ray             the first hit ahead; there is no range
 *     surface=miss    "tmp_intersectionDistance > 0", "intersectionDistance > Epsilon"
 *     scale           Epsilon is an absolute length, that of 1 */
#include "library.h"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>

const char sure_candidate_entry[] = "unit aligned square ray surface=miss scale=1e-3..1e6";

using vector = glm::vec<3, real>;

static vector vector_at(const real *from)
{
    return vector(from[0], from[1], from[2]);
}

int PEER(plane)(const real *ray, const real *plane, peer_hit *hit)
{
    real t;
    bool meets = glm::intersectRayPlane(vector_at(ray), vector_at(ray + 3), vector_at(plane),
                                        vector_at(plane + 3), t);
    return meets ? found_at(ray, t, hit) : SURE_CANDIDATE_MISS;
}

int PEER(sphere)(const real *ray, const real *sphere, peer_hit *hit)
{
    real t;
    bool meets = glm::intersectRaySphere(vector_at(ray), vector_at(ray + 3), vector_at(sphere),
                                         sphere[3] * sphere[3], t);
    return meets ? found_at(ray, t, hit) : SURE_CANDIDATE_MISS;
}

/* SPDX-License-Identifier: MIT */
/* OGRE, the Object-Oriented Graphics Rendering Engine: Math::intersects of a Ray
 * (https://ogrecave.github.io/ogre/api/1.12/class_ogre_1_1_math.html).
 *
 *     unit, aligned   both are compared with an absolute epsilon, that of 1
 *     ray             there is no range; what is behind is answered too, with t < 0: a miss here
 *     inside=0        "discardInside", of boxes always
 *     surface=miss    a box is not hit where it is left; the page does not say
 *     scale           squares of lengths neither overflow nor underflow */
#include "library.h"

#include <Ogre.h>

const char sure_candidate_entry[] = "unit aligned ray inside=0 surface=miss scale=1e-3..1e6";

static Ogre::Vector3 vector_at(const real *from)
{
    return Ogre::Vector3(from[0], from[1], from[2]);
}

template <class Surface> static int answer(const Surface &surface, const real *ray, peer_hit *hit)
{
    auto [meets, t] =
        Ogre::Math::intersects(Ogre::Ray(vector_at(ray), vector_at(ray + 3)), surface);
    return meets ? found_at(ray, t, hit) : SURE_CANDIDATE_MISS;
}

int PEER(plane)(const real *ray, const real *plane, peer_hit *hit)
{
    return answer(Ogre::Plane(vector_at(plane + 3), vector_at(plane)), ray, hit);
}

int PEER(sphere)(const real *ray, const real *sphere, peer_hit *hit)
{
    return answer(Ogre::Sphere(vector_at(sphere), sphere[3]), ray, hit);
}

int PEER(box)(const real *ray, const real *box, peer_hit *hit)
{
    return answer(Ogre::AxisAlignedBox(vector_at(box), vector_at(box + 3)), ray, hit);
}

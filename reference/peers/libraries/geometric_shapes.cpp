/* SPDX-License-Identifier: MIT */
/* geometric_shapes, of ROS and MoveIt: bodies::Body::intersectsRay
 * (https://docs.ros.org/en/noetic/api/geometric_shapes/html/classbodies_1_1Body.html).
 *
 *     centred        a body's pose is its middle, a cylinder's axis is z
 *     unit           t is told from the point that is answered
 *     ray            "the set of intersections, in order, along the ray": the first
 *     surface=miss   where the ray starts is none of them; the page does not say
 *     scale          lengths are compared with an absolute epsilon */
#include "library.h"

#include <geometric_shapes/bodies.h>

const char sure_candidate_entry[] = "unit centred ray surface=miss scale=1e-3..1e6";

template <class Body> struct body {
    std::unique_ptr<Body> solid;
    explicit body(const shapes::Shape &shape) : solid(new Body(&shape))
    {
    }
    int meet(const real *ray, peer_hit *hit) const
    {
        const Eigen::Vector3d from(ray[0], ray[1], ray[2]), way(ray[3], ray[4], ray[5]);
        EigenSTL::vector_Vector3d points;
        bool meets = solid->intersectsRay(from, way, &points, 1) && !points.empty();
        return found_at(ray, meets ? way.dot(points[0] - from) : NAN, hit);
    }
};

ANSWER_BY(sphere, body<bodies::Sphere>, shapes::Sphere(n[3]))
ANSWER_BY(cylinder, body<bodies::Cylinder>, shapes::Cylinder(n[6], 2 * n[5]))
ANSWER_BY(box, body<bodies::Box>, shapes::Box(2 * n[3], 2 * n[4], 2 * n[5]))

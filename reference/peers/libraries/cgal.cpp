/* SPDX-License-Identifier: MIT */
/* CGAL, the Computational Geometry Algorithms Library: do_intersect in the kernel PEER_KERNEL
 * (https://doc.cgal.org/5.5/Kernel_23/group__do__intersect__linear__grp.html). PEER_EXACT, the one
 * with exact constructions, is a control: it has to be right everywhere, of any numbers.
 *
 *     decision      whether they meet, not where
 *     ray           a Ray_3 (the exact kernel: a Segment_3, too)
 *     square        a Sphere_3 is made of its radius' square, which others round; and
 *     unit, local   ... a Ray_3 of its second point, which "inexact constructions" would round,
 *     scale         ... were the numbers not floats (PEER_FLOAT) of like sizes */
#include "library.h"

#ifdef PEER_EXACT
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
const char sure_candidate_entry[] = "decision";
#else
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
const char sure_candidate_entry[] = "decision unit local ray square scale=1e-3..1e3";
#endif

using kernel = CGAL::PEER_KERNEL;
using point = kernel::Point_3;
using vector = kernel::Vector_3;

template <class Object> struct object {
    Object of;
    int meet(const real *ray, peer_hit *) const
    {
        const point origin(ray[0], ray[1], ray[2]);
        const vector way(ray[3], ray[4], ray[5]);
        const point from = origin + kernel::FT(ray[6]) * way;
        if (std::isinf(ray[7]))
            return do_intersect(kernel::Ray_3(from, way), of);
        return do_intersect(kernel::Segment_3(from, origin + kernel::FT(ray[7]) * way), of);
    }
};
using plane = object<kernel::Plane_3>;
using sphere = object<kernel::Sphere_3>;
ANSWER_BY(plane, plane, kernel::Plane_3(point(n[0], n[1], n[2]), vector(n[3], n[4], n[5])))
ANSWER_BY(sphere, sphere, kernel::Sphere_3(point(n[0], n[1], n[2]), CGAL::square(kernel::FT(n[3]))))

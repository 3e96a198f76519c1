/* SPDX-License-Identifier: MIT */
/* CGAL's linear kernel over rationals, and its objects from doubles without rounding. */
#ifndef REFERENCE_CGAL_KERNEL_H
#define REFERENCE_CGAL_KERNEL_H

#include <CGAL/Simple_cartesian.h>

#include <surehit/object.h>

#include "cgal_exact.h"

namespace exact {

using kernel = CGAL::Simple_cartesian<rational>;

kernel::Point_3 kernel_point(const sure_vec3 &p);
kernel::Vector_3 kernel_vector(const sure_vec3 &v);
rational squared(double x);

/* The points between two parallel planes, these included. */
struct layer {
    kernel::Point_3 low, high;
    kernel::Vector_3 axis; /* from low to high, at right angles to both */
};

}

#endif

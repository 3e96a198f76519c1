/* SPDX-License-Identifier: MIT */
/* Eigen: ParametrizedLine::intersectionParameter of a Hyperplane
 * (https://eigen.tuxfamily.org/dox/classEigen_1_1ParametrizedLine.html, .../Hyperplane.html).
 *
 *     unit, aligned   direction and normal are "assumed to be normalized"
 *     ray             t is that of the whole line, infinite or no number where there is none */
#include "library.h"

#include <Eigen/Geometry>

const char sure_candidate_entry[] = "unit aligned ray";

using vector = Eigen::Matrix<real, 3, 1>;
using vector_of = Eigen::Map<const vector>;

int PEER(plane)(const real *ray, const real *plane, peer_hit *hit)
{
    Eigen::ParametrizedLine<real, 3> line{vector_of(ray), vector_of(ray + 3)};
    Eigen::Hyperplane<real, 3> wall{vector_of(plane + 3), vector(vector_of(plane))};
    return found_at(ray, line.intersectionParameter(wall), hit);
}

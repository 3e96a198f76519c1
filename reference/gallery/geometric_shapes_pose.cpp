// SPDX-License-Identifier: MIT
// A cylinder is turned half round, but for 0.0125 radians, by Eigen's own rotation.
#include <geometric_shapes/bodies.h>
int main()
{
    Eigen::Vector3d axis(std::sin(0.0125), 0, -std::cos(0.0125));
    using Eigen::Quaterniond, Eigen::Vector3d;
    Quaterniond turn = Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis);
    printf("the rotation's length differs from 1 by %.1e\n", std::abs(turn.norm() - 1));
    puts("expected a pose, got");
    fflush(stdout);
    bodies::Cylinder().setPose(Eigen::Isometry3d(TURN));
    puts("a pose");
}

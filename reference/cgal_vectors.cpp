/* SPDX-License-Identifier: MIT */
/* The questions about vectors and coefficients alone: all answers are p + q sqrt(D) or quotients by
 * a root, in integers. */
#include "reference.h"

#include "cgal_shape.h"

using namespace exact;

namespace {

sure_vec3 nearest_vector(const vector &numerators, const integer &denominator, long exponent)
{
    return {nearest(real{surd(numerators.x), denominator, exponent}),
            nearest(real{surd(numerators.y), denominator, exponent}),
            nearest(real{surd(numerators.z), denominator, exponent})};
}

/* C + (half / |N|) N = (C N.N + half N sqrt(N.N)) / N.N; half is h/2 with its sign, in C's unit. */
sure_vec3 nearest_end(const vector &centre, const vector &axis, const integer &half, long exponent)
{
    const integer norm = square(axis);
    const auto component = [&](const integer &c, const integer &n) {
        return nearest(real{make_surd(c * norm, half * n, norm), norm, exponent});
    };
    return {component(centre.x, axis.x), component(centre.y, axis.y), component(centre.z, axis.z)};
}

/* a t^2 + 2 b t + c is quadratic's own form; its line only carries the roots' unit. */
sure_roots nearest_roots(const quadratic &equation, double roots[2])
{
    const line unit_line = {{}, {}, 0};
    if (equation.vanishes())
        return SURE_ROOTS_ALL;
    const std::vector<real> found = equation.roots(unit_line);
    if (found.empty())
        return SURE_ROOTS_NONE;
    roots[0] = nearest(found.front());
    if (equation.leading() == 0)
        return SURE_ROOTS_ONE;
    roots[1] = nearest(found.back());
    return SURE_ROOTS_TWO;
}

}

extern "C" {

sure_vec3 reference_wall_normal(const sure_object *object, sure_vec3 point)
{
    const shape_row &row = row_of(*object);
    if (!row.wall_normal)
        contradiction("an object without a wall");
    return row.wall_normal(*object, point);
}

int reference_height(const sure_object *object, sure_vec3 point)
{
    const shape_row &row = row_of(*object);
    if (!row.height)
        contradiction("an object without a wall");
    return row.height(*object, point);
}

void reference_end_points(sure_vec3 centre, sure_vec3 axis, double height, sure_vec3 *low,
                          sure_vec3 *high)
{
    common_unit length;
    length.show(centre).show(height);
    const vector twice_centre = integer(2) * length.count(centre);
    const integer whole = length.count(height);
    const vector n = count_alone(axis);
    *low = nearest_end(twice_centre, n, -whole, length.exponent() - 1);
    *high = nearest_end(twice_centre, n, whole, length.exponent() - 1);
}

sure_roots reference_quadratic(double a, double half_b, double c, double roots[2])
{
    common_unit unit;
    unit.show(a).show(half_b).show(c);
    const integer p = unit.count(a), q = unit.count(half_b), r = unit.count(c);
    return nearest_roots(quadratic(p, q, r, integer(1), q * q - p * r), roots);
}

/* The length of N cancels, and so does its unit. */
sure_vec3 reference_project(sure_vec3 v, sure_vec3 n)
{
    const common_unit unit = common_unit().show(v);
    const vector along = count_alone(n);
    return nearest_vector(dot(along, unit.count(v)) * along, square(along), unit.exponent());
}

sure_vec3 reference_reflect(sure_vec3 v, sure_vec3 n)
{
    const common_unit unit = common_unit().show(v);
    const vector along = count_alone(n), from = unit.count(v);
    const vector mirrored = integer(2) * dot(along, from) * along - square(along) * from;
    return nearest_vector(mirrored, square(along), unit.exponent());
}
}

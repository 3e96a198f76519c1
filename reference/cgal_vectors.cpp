/* The questions about vectors and coefficients alone: all answers are p + q sqrt(D) or quotients by
 * a root, in integers. */
#include "reference.h"

#include "cgal_line.h"

using namespace exact;

namespace {

sure_vec3 nearest_vector(const vector &numerators, const integer &denominator, long exponent)
{
    return {nearest(real{surd(numerators.x), denominator, exponent}),
            nearest(real{surd(numerators.y), denominator, exponent}),
            nearest(real{surd(numerators.z), denominator, exponent})};
}

sure_vec3 nearest_vector(const unit_vector &v)
{
    return {nearest(v[0]), nearest(v[1]), nearest(v[2])};
}

vector count_alone(const sure_vec3 &v)
{
    return common_unit().show(v).count(v);
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

/* P - S with S = Q + (|q| / cos(theta)) A/|A|, q = P - Q, A = base - Q, cos^2(theta) = H / (H +
 * r^2): H (P - S) = H q - A sqrt(X), X = q.q (H + r^2), and the square of that is H^2 q.q + H X
 * - 2 H (A.q) sqrt(X). */
unit_vector cone_wall_normal(const vector &q, const vector &axis, const integer &radius)
{
    const integer length = square(axis);
    const integer under_root = square(q) * (length + square(radius));
    const auto component = [&](const integer &n, const integer &a) {
        return make_surd(length * n, -a, under_root);
    };
    const surd norm = make_surd(square(length) * square(q) + length * under_root,
                                integer(-2) * length * dot(axis, q), under_root);
    return unit({component(q.x, axis.x), component(q.y, axis.y), component(q.z, axis.z)}, surd(1),
                norm);
}

/* A wall's object in integers: q leads from base or apex to the point, axis to the other end. */
struct wall_frame {
    vector q, axis;
    integer radius;
};

wall_frame make_wall_frame(const sure_vec3 &from, const sure_vec3 &to, double radius,
                           const sure_vec3 &point)
{
    common_unit length;
    length.show(from).show(to).show(radius).show(point);
    return {length.count(point) - length.count(from), length.count(to) - length.count(from),
            length.count(radius)};
}

wall_frame make_wall_frame(const sure_object &object, const sure_vec3 &point)
{
    if (object.shape == SURE_SHAPE_CYLINDER)
        return make_wall_frame(object.as.cylinder.base, object.as.cylinder.top,
                               object.as.cylinder.radius, point);
    if (object.shape == SURE_SHAPE_CONE)
        return make_wall_frame(object.as.cone.apex, object.as.cone.base, object.as.cone.radius,
                               point);
    contradiction("an object without a wall");
}

bool is_zero(const vector &v)
{
    return square(v).sign() == 0;
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
    const wall_frame wall = make_wall_frame(*object, point);
    const integer length = square(wall.axis);
    if (object->shape == SURE_SHAPE_CYLINDER) {
        const vector outward = length * wall.q - dot(wall.axis, wall.q) * wall.axis;
        return is_zero(outward) ? sure_vec3{0, 0, 0} : nearest_vector(unit(outward));
    }
    if (is_zero(wall.q))
        return nearest_vector(unit(integer(-1) * wall.axis));
    const unit_vector outward = cone_wall_normal(wall.q, wall.axis, wall.radius);
    return outward[0].radicand.sign() == 0 ? sure_vec3{0, 0, 0} : nearest_vector(outward);
}

int reference_height(const sure_object *object, sure_vec3 point)
{
    const wall_frame wall = make_wall_frame(*object, point);
    const integer along = dot(wall.axis, wall.q), length = square(wall.axis);
    if (object->shape == SURE_SHAPE_CYLINDER)
        return along.sign() >= 0 && along <= length;
    return along.sign() >= 0 && square(wall.q) <= length + square(wall.radius);
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

/* SPDX-License-Identifier: MIT */
/* The table of shapes, and what their rows share. */
#include "cgal_shape.h"

#include <algorithm>

namespace exact {

#define DECLARE(shape, SHAPE) extern const shape_row shape##_row;
SURE_EACH_SHAPE(DECLARE)
#undef DECLARE

const shape_row &row_of(const sure_object &object)
{
#define ROW(shape, SHAPE) &shape##_row,
    static const shape_row *const rows[] = {SURE_EACH_SHAPE(ROW)};
#undef ROW
    if (static_cast<unsigned>(object.shape) >= std::size(rows))
        contradiction("an object without a shape");
    return *rows[object.shape];
}

std::unique_ptr<question> ask(const sure_ray &ray, const sure_object &object)
{
    return row_of(object).ask(ray, object);
}

bool finite(const sure_vec3 &v)
{
    return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}

bool equal(const sure_vec3 &u, const sure_vec3 &v)
{
    return order_key(u.x) == order_key(v.x) && order_key(u.y) == order_key(v.y) &&
           order_key(u.z) == order_key(v.z);
}

bool is_zero(const sure_vec3 &v)
{
    return equal(v, {0, 0, 0});
}

sure_field check_facing(const sure_vec3 &point, sure_field point_field, const sure_vec3 &normal)
{
    if (!finite(point))
        return point_field;
    return finite(normal) && !is_zero(normal) ? SURE_FIELD_NONE : SURE_FIELD_NORMAL;
}

sure_field check_ends(const sure_vec3 &base, const sure_vec3 &end, sure_field end_field)
{
    if (!finite(base))
        return SURE_FIELD_BASE;
    return finite(end) && !equal(base, end) ? SURE_FIELD_NONE : end_field;
}

sure_field check_radius(sure_field earlier, double radius)
{
    if (earlier != SURE_FIELD_NONE)
        return earlier;
    return is_finite(radius) && order_key(radius) >= 0 ? SURE_FIELD_NONE : SURE_FIELD_RADIUS;
}

/* The larger of two sides is that of an intersection of convex bodies. */
int where_capped(const sure_object &object, const kernel::Point_3 &p)
{
    const shape_row &row = row_of(object);
    int side = CGAL::sign(row.surface(object, p));
    for (const layer &between : row.layers(object)) {
        const int beneath = -kernel::Plane_3(between.low, between.axis).oriented_side(p);
        const int beyond = kernel::Plane_3(between.high, between.axis).oriented_side(p);
        side = std::max({side, beneath, beyond});
    }
    return side;
}

surd dot(const vector &u, const point &v)
{
    return v[0] * u.x + v[1] * u.y + v[2] * u.z;
}

surd square(const point &v)
{
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

surd square_of_cross(const vector &u, const point &v)
{
    const point product = {v[2] * u.y - v[1] * u.z, v[0] * u.z - v[2] * u.x,
                           v[1] * u.x - v[0] * u.y};
    return square(product);
}

point times(const vector &v, const surd &factor)
{
    return {factor * v.x, factor * v.y, factor * v.z};
}

point times(const integer &factor, const point &v)
{
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

point minus(const point &u, const point &v)
{
    return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

int side_of_ends(const frame &object, const surd &along, const integer &w)
{
    return std::max(sign(-along), sign(along - integer(square(object.axis) * w)));
}

wall_frame::wall_frame(const sure_vec3 &from, const sure_vec3 &to, double radius_,
                       const sure_vec3 &p)
{
    common_unit length;
    length.show(from).show(to).show(radius_).show(p);
    q = length.count(p) - length.count(from);
    axis = length.count(to) - length.count(from);
    radius = length.count(radius_);
}

sure_vec3 nearest_vector(const unit_vector &v)
{
    return {nearest(v[0]), nearest(v[1]), nearest(v[2])};
}

}

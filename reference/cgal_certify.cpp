/* The chord proved against the object's definition, by a route without its quadratic.
 *
 * Every object here is convex, so what a line has of it lies between two points. These are right
 * when they are on the boundary, what lies beyond them is outside, and the middle is inside for a
 * line said to meet the interior and boundary for any other. Such points have coordinates p + q
 * sqrt(D), at which the definitions below are evaluated in CGAL's exact numbers.
 *
 * That there is no such point is proved by rational places alone. The curved surface's value is
 * a quadratic in t, so on the line's part between the end planes it is least at an end of that
 * part or, where it opens upwards, at its vertex, found from its values at t = -1, 0, 1. When
 * all these places are outside, so is the whole line.
 *
 * Normals are proved by the gradient of the definition at the exact point, divided by its length as
 * it is, without the closed forms that the shapes use. */
#include "reference.h"

#include <algorithm>
#include <vector>

#include "cgal_kernel.h"
#include "cgal_line.h"

using namespace exact;

namespace {

using point = std::array<surd, 3>;

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

int sign(const surd &x)
{
    return x.sign();
}

/* An object in integers: `anchor` is centre, point, base or apex, `axis` leads to the other end or
 * is the normal. */
struct frame {
    sure_shape shape;
    line on;
    vector anchor, axis;
    integer radius;
};

/* Where a point q / w away from the anchor is. */
int side_of_flat(const frame &object, const point &q, const integer &w)
{
    if (sign(dot(object.axis, q)) != 0)
        return 1;
    if (object.shape == SURE_SHAPE_PLANE)
        return 0;
    return sign(square(q) - square(integer(object.radius * w))) > 0 ? 1 : 0;
}

int side_of_solid(const frame &object, const point &q, const integer &w)
{
    const integer reach = square(integer(object.radius * w));
    if (object.shape == SURE_SHAPE_SPHERE)
        return sign(square(q) - reach);
    const integer length = square(object.axis);
    const surd along = dot(object.axis, q);
    const surd across = square_of_cross(object.axis, q);
    const int ends = std::max(sign(-along), sign(along - integer(length * w)));
    if (object.shape == SURE_SHAPE_CYLINDER)
        return std::max(ends, sign(across - integer(length * reach)));
    return std::max(ends, sign(across * length - along * along * square(object.radius)));
}

/* The object's numbers whatever its shape; far_end is where the axis leads. */
struct fields {
    sure_vec3 anchor, far_end, normal;
    double radius;
};

fields fields_of(const sure_object &object)
{
    switch (object.shape) {
    case SURE_SHAPE_PLANE:
        return {object.as.plane.point, {}, object.as.plane.normal, 0};
    case SURE_SHAPE_DISC:
        return {object.as.disc.centre, {}, object.as.disc.normal, object.as.disc.radius};
    case SURE_SHAPE_SPHERE:
        return {object.as.sphere.centre, {}, {}, object.as.sphere.radius};
    case SURE_SHAPE_CYLINDER:
        return {object.as.cylinder.base, object.as.cylinder.top, {}, object.as.cylinder.radius};
    case SURE_SHAPE_CONE:
        return {object.as.cone.apex, object.as.cone.base, {}, object.as.cone.radius};
    }
    contradiction("an object without a shape");
}

bool is_flat(sure_shape shape)
{
    return shape == SURE_SHAPE_PLANE || shape == SURE_SHAPE_DISC;
}

frame make_frame(const sure_ray &ray, const sure_object &object)
{
    const fields given = fields_of(object);
    common_unit length, step;
    length.show(ray.origin).show(given.anchor).show(given.far_end).show(given.radius);
    step.show(given.normal);
    const vector anchor = length.count(given.anchor);
    return {object.shape, make_line(ray, length), anchor,
            is_flat(object.shape) ? step.count(given.normal) : length.count(given.far_end) - anchor,
            length.count(given.radius)};
}

int side_at(const frame &object, const surd &numerator, const integer &denominator)
{
    const real t = object.on.at(numerator, denominator);
    const point q = affine(object.on.origin - object.anchor, object.on.direction, t);
    return is_flat(object.shape) ? side_of_flat(object, q, t.denominator)
                                 : side_of_solid(object, q, t.denominator);
}

point times(const vector &v, const surd &factor)
{
    return {factor * v.x, factor * v.y, factor * v.z};
}

point minus(const point &u, const point &v)
{
    return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

point times(const integer &factor, const point &v)
{
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

/* The wall's gradient, halved, at a point q / w from the anchor, times w: of |A x q|^2 it is
 * H q - (A.q) A, of (A.q)^2 it is (A.q) A. */
point wall_gradient(const frame &object, const point &q)
{
    const integer length = square(object.axis);
    const surd along = dot(object.axis, q);
    const point across = minus(times(length, q), times(object.axis, along));
    if (object.shape == SURE_SHAPE_CYLINDER)
        return across;
    return minus(times(length, across), times(object.axis, along * square(object.radius)));
}

/* The way out at a boundary point q / w from the anchor, of any length. */
point way_out(const frame &object, const point &q, const integer &w)
{
    if (is_flat(object.shape))
        return times(object.axis, surd(1));
    if (object.shape != SURE_SHAPE_SPHERE) {
        const surd along = dot(object.axis, q);
        if (sign(along - integer(square(object.axis) * w)) == 0)
            return times(object.axis, surd(1)); /* the top, or the base of a cone */
        if (sign(along) == 0)
            return times(object.axis, surd(-1)); /* the base, or the apex of a cone */
    }
    if (object.radius.sign() == 0)
        return times(object.on.direction, surd(-1));
    return object.shape == SURE_SHAPE_SPHERE ? q : wall_gradient(object, q);
}

/* Does the answered normal round as the way out does, divided by its length? */
bool proves_normal(const frame &object, const question &about, const surd &numerator,
                   const integer &denominator)
{
    const real t = object.on.at(numerator, denominator);
    const point q = affine(object.on.origin - object.anchor, object.on.direction, t);
    const point out = way_out(object, q, t.denominator);
    const unit_vector normal = about.normal(t), expected = unit(out, surd(1), square(out));
    for (std::size_t i = 0; i < 3; i++) {
        if (reference_ulps(nearest(normal[i]), nearest(expected[i])) != 0)
            return false;
    }
    return true;
}

bool proves_whole_line(const frame &object, const question &about)
{
    return side_at(object, surd(0), integer(1)) == 0 &&
           side_at(object, surd(1), integer(1)) == 0 &&
           proves_normal(object, about, surd(0), integer(1));
}

/* Its ends, its middle, points beyond its ends; normals where it is boundary. */
bool proves_chord(const frame &object, const question &about, const span &chord)
{
    if (!chord.low && !chord.high)
        return proves_whole_line(object, about);
    if (!chord.low || !chord.high)
        return false;
    const integer unit = chord.low->denominator * chord.high->denominator;
    const surd low = chord.low->numerator * chord.high->denominator;
    const surd high = chord.high->numerator * chord.low->denominator;
    const auto side = [&](const surd &place) { return side_at(object, place, unit); };
    const auto normal = [&](const surd &place, const integer &times_unit) {
        return proves_normal(object, about, place, unit * times_unit);
    };
    const int order = sign(high - low), middle = side_at(object, low + high, unit + unit);
    if (order < (chord.solid ? 1 : 0) || middle != (chord.solid ? -1 : 0))
        return false;
    return side(low) == 0 && side(high) == 0 && side(low - unit) > 0 && side(high + unit) > 0 &&
           normal(low, 1) && normal(high, 1) && (chord.solid || normal(low + high, 2));
}

struct line_in_space {
    kernel::Point_3 origin;
    kernel::Vector_3 direction;

    kernel::Point_3 at(const rational &t) const { return origin + t * direction; }
};

/* The t between the object's end planes; every t for a sphere. */
struct stretch {
    bool empty, bounded;
    rational low, high;
};

stretch between_planes(const sure_object &object, const line_in_space &on)
{
    if (object.shape == SURE_SHAPE_SPHERE)
        return {false, false, 0, 0};
    const layer planes = layer_of(object);
    const rational start = (on.origin - planes.low) * planes.axis;
    const rational end = (planes.high - planes.low) * planes.axis;
    const rational speed = on.direction * planes.axis;
    if (speed == 0)
        return {start < 0 || start > end, false, 0, 0};
    const rational at_low = -start / speed, at_high = (end - start) / speed;
    return {false, true, std::min(at_low, at_high), std::max(at_low, at_high)};
}

/* Where the surface's value is least on the stretch. */
std::vector<rational> lowest_places(const sure_object &object, const line_in_space &on,
                                    const stretch &part)
{
    std::vector<rational> places;
    if (part.bounded)
        places = {part.low, part.high};
    if (object.shape == SURE_SHAPE_PLANE)
        return part.bounded ? places : std::vector<rational>{0};
    const rational before = surface_value(object, on.at(-1)), at = surface_value(object, on.at(0));
    const rational after = surface_value(object, on.at(1));
    const rational bend = before + after - 2 * at;
    if (bend <= 0)
        return places;
    const rational vertex = (before - after) / (2 * bend);
    if (!part.bounded || (part.low < vertex && vertex < part.high))
        places.push_back(vertex);
    return places;
}

bool proves_empty(const sure_object &object, const line_in_space &on)
{
    const stretch part = between_planes(object, on);
    if (part.empty)
        return true;
    const std::vector<rational> places = lowest_places(object, on, part);
    const auto outside = [&](const rational &t) {
        const int side = where(object, on.at(t));
        return object.shape == SURE_SHAPE_PLANE ? side != 0 : side > 0;
    };
    return !places.empty() && std::all_of(places.begin(), places.end(), outside);
}

}

extern "C" int reference_certify(const sure_ray *ray, const sure_object *object)
{
    const std::unique_ptr<question> about = ask(*ray, *object);
    const span chord = about->chord();
    if (chord.empty)
        return proves_empty(*object, {kernel_point(ray->origin), kernel_vector(ray->direction)});
    return proves_chord(make_frame(*ray, *object), *about, chord);
}

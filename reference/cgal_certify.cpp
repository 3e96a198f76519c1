/* SPDX-License-Identifier: MIT */
/* The chord proved against the object's definition, by a route without its quadratic.
 *
 * Every object here is convex, so what a line has of it lies between two points. These are right
 * when they are on the boundary, what lies beyond them is outside, and the middle is inside for a
 * line said to meet the interior and boundary for any other. Such points have coordinates p + q
 * sqrt(D), at which the definitions in the shapes' rows are evaluated in CGAL's exact numbers.
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

#include "cgal_shape.h"

using namespace exact;

namespace {

frame make_frame(const sure_ray &ray, const sure_object &object)
{
    const fields given = row_of(object).fields_of(object);
    common_unit length, step;
    length.show(ray.origin).show(given.anchor).show(given.far_end).show(given.radius);
    step.show(given.normal);
    const vector anchor = length.count(given.anchor);
    return {make_line(ray, length), anchor,
            is_zero(given.normal) ? length.count(given.far_end) - anchor : step.count(given.normal),
            length.count(given.radius)};
}

/* What is proved, and of what. */
struct claim {
    const shape_row &row;
    const frame object;
    const question &about;

    /* The place on the line as its distance from the anchor, q / t.denominator. */
    point from_anchor(const real &t) const
    {
        return affine(object.on.origin - object.anchor, object.on.direction, t);
    }
};

int side_at(const claim &of, const surd &numerator, const integer &denominator)
{
    const real t = of.object.on.at(numerator, denominator);
    return of.row.side(of.object, of.from_anchor(t), t.denominator);
}

/* Does the answered normal round as the way out does, divided by its length? */
bool proves_normal(const claim &of, const surd &numerator, const integer &denominator)
{
    const real t = of.object.on.at(numerator, denominator);
    const point out = of.row.way_out(of.object, of.from_anchor(t), t.denominator);
    const unit_vector normal = of.about.normal(t), expected = unit(out, surd(1), square(out));
    for (std::size_t i = 0; i < 3; i++) {
        if (reference_ulps(nearest(normal[i]), nearest(expected[i])) != 0)
            return false;
    }
    return true;
}

bool proves_whole_line(const claim &of)
{
    return side_at(of, surd(0), integer(1)) == 0 && side_at(of, surd(1), integer(1)) == 0 &&
           proves_normal(of, surd(0), integer(1));
}

/* Its ends, its middle, points beyond its ends; normals where it is boundary. */
bool proves_chord(const claim &of, const span &chord)
{
    if (!chord.low && !chord.high)
        return proves_whole_line(of);
    if (!chord.low || !chord.high)
        return false;
    const integer unit = chord.low->denominator * chord.high->denominator;
    const surd low = chord.low->numerator * chord.high->denominator;
    const surd high = chord.high->numerator * chord.low->denominator;
    const auto side = [&](const surd &place) { return side_at(of, place, unit); };
    const auto normal = [&](const surd &place, const integer &times_unit) {
        return proves_normal(of, place, unit * times_unit);
    };
    const int order = sign(high - low), middle = side_at(of, low + high, unit + unit);
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

/* The t at which the line is between two planes, or between all of an object's; every t for a
 * sphere. */
struct stretch {
    bool empty, bounded;
    rational low, high;
};

stretch within(const layer &planes, const line_in_space &on)
{
    const rational start = (on.origin - planes.low) * planes.axis;
    const rational end = (planes.high - planes.low) * planes.axis;
    const rational speed = on.direction * planes.axis;
    if (speed == 0)
        return {start < 0 || start > end, false, 0, 0};
    const rational at_low = -start / speed, at_high = (end - start) / speed;
    return {false, true, std::min(at_low, at_high), std::max(at_low, at_high)};
}

stretch between_planes(const sure_object &object, const line_in_space &on)
{
    stretch all = {false, false, 0, 0};
    for (const layer &planes : row_of(object).layers(object)) {
        const stretch one = within(planes, on);
        all.empty = all.empty || one.empty;
        if (!one.bounded)
            continue;
        all.low = all.bounded ? std::max(all.low, one.low) : one.low;
        all.high = all.bounded ? std::min(all.high, one.high) : one.high;
        all.bounded = true;
    }
    all.empty = all.empty || all.low > all.high;
    return all;
}

/* Where the surface's value is least on the stretch. */
std::vector<rational> lowest_places(const sure_object &object, const line_in_space &on,
                                    const stretch &part)
{
    std::vector<rational> places;
    if (part.bounded)
        places = {part.low, part.high};
    const auto surface = row_of(object).surface;
    if (!surface)
        return places;
    const rational before = surface(object, on.at(-1)), at = surface(object, on.at(0));
    const rational after = surface(object, on.at(1));
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
        return row_of(object).where(object, on.at(t)) > 0;
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
    return proves_chord({row_of(*object), make_frame(*ray, *object), *about}, chord);
}

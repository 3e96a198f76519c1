/* SPDX-License-Identifier: MIT */
/* The C interface: validity, and the answers read off the exact chord. */
#include "reference.h"

#include <limits>

#include "cgal_shape.h"

using namespace exact;

namespace {

sure_field check_ray(const sure_ray &ray)
{
    if (!finite(ray.origin))
        return SURE_FIELD_O;
    if (!finite(ray.direction) || is_zero(ray.direction))
        return SURE_FIELD_D;
    if (!is_finite(ray.t_min) || order_key(ray.t_min) < 0)
        return SURE_FIELD_T_MIN;
    if (is_nan(ray.t_max) || order_key(ray.t_max) < order_key(ray.t_min))
        return SURE_FIELD_T_MAX;
    return SURE_FIELD_NONE;
}

/* Is t in the ray's interval? */
bool after_start(const sure_ray &ray, const real &t)
{
    return compare(t, to_dyadic(ray.t_min)) >= 0;
}

bool before_end(const sure_ray &ray, const real &t)
{
    return !is_finite(ray.t_max) || compare(t, to_dyadic(ray.t_max)) <= 0;
}

bool on_ray(const sure_ray &ray, const real &t)
{
    return after_start(ray, t) && before_end(ray, t);
}

/* Boundary points of a chord through the interior are its ends; any other chord is boundary all
 * along, and its first point on the ray counts. */
std::optional<real> first_boundary_point(const sure_ray &ray, const question &about)
{
    const span chord = about.chord();
    if (chord.empty)
        return std::nullopt;
    if (chord.solid) {
        if (on_ray(ray, *chord.low))
            return chord.low;
        return on_ray(ray, *chord.high) ? chord.high : std::nullopt;
    }
    const real first = chord.low && after_start(ray, *chord.low)
                           ? *chord.low
                           : about.on().at(to_dyadic(ray.t_min));
    if (!before_end(ray, first) || (chord.high && compare(first, *chord.high) > 0))
        return std::nullopt;
    return first;
}

bool chord_meets_ray(const sure_ray &ray, const span &chord)
{
    return !chord.empty && (!chord.low || before_end(ray, *chord.low)) &&
           (!chord.high || after_start(ray, *chord.high));
}

/* A ray's exact first hit, and what it was asked of. */
struct exact_hit {
    sure_status status;
    std::unique_ptr<question> about;
    std::optional<real> t;
};

exact_hit find_hit(const sure_ray &ray, const sure_object &object)
{
    if (reference_check(&ray, &object) != SURE_FIELD_NONE)
        return {SURE_INVALID, nullptr, std::nullopt};
    exact_hit hit = {SURE_MISS, ask(ray, object), std::nullopt};
    hit.t = first_boundary_point(ray, *hit.about);
    if (hit.t)
        hit.status = SURE_HIT;
    return hit;
}

/* Is |x - middle| <= error? */
template <class exact_number> bool within(const exact_number &x, double middle, double error)
{
    if (!is_finite(middle) || is_nan(error) || order_key(error) < 0)
        return false;
    if (!is_finite(error))
        return true;
    return compare(x, to_dyadic(middle) - to_dyadic(error)) >= 0 &&
           compare(x, to_dyadic(middle) + to_dyadic(error)) <= 0;
}

}

extern "C" {

sure_field reference_check(const sure_ray *ray, const sure_object *object)
{
    const sure_field field = check_ray(*ray);
    return field == SURE_FIELD_NONE ? row_of(*object).check(*object) : field;
}

sure_status reference_hit(const sure_ray *ray, const sure_object *object, double *t,
                          sure_part *part, sure_vec3 *normal)
{
    const exact_hit hit = find_hit(*ray, *object);
    if (hit.status != SURE_HIT)
        return hit.status;
    if (t)
        *t = nearest(*hit.t);
    if (part)
        *part = hit.about->part(*hit.t);
    if (normal) {
        const unit_vector n = hit.about->normal(*hit.t);
        *normal = {nearest(n[0]), nearest(n[1]), nearest(n[2])};
    }
    return SURE_HIT;
}

sure_status reference_interval(const sure_ray *ray, const sure_object *object,
                               sure_interval *interval)
{
    if (reference_check(ray, object) != SURE_FIELD_NONE)
        return SURE_INVALID;
    const std::unique_ptr<question> about = ask(*ray, *object);
    const span chord = about->chord();
    if (!chord_meets_ray(*ray, chord))
        return SURE_MISS;
    if (!interval)
        return SURE_HIT;
    const int64_t infinite_key = order_key(std::numeric_limits<double>::infinity());
    interval->t_enter = chord.low ? nearest(*chord.low) : from_order_key(-infinite_key);
    interval->t_leave = chord.high ? nearest(*chord.high) : from_order_key(infinite_key);
    interval->enter_part = chord.low ? about->part(*chord.low) : SURE_PART_SURFACE;
    interval->leave_part = chord.high ? about->part(*chord.high) : SURE_PART_SURFACE;
    return SURE_HIT;
}

sure_status reference_occluded(const sure_ray *ray, const sure_object *object)
{
    return find_hit(*ray, *object).status;
}

sure_status reference_hit_order(const sure_ray *ray, const sure_object *first,
                                const sure_object *second, int *order)
{
    const exact_hit one = find_hit(*ray, *first), other = find_hit(*ray, *second);
    if (one.status == SURE_INVALID || other.status == SURE_INVALID)
        return SURE_INVALID;
    if (one.status == SURE_MISS || other.status == SURE_MISS)
        return SURE_MISS;
    if (order)
        *order = compare(*one.t, *other.t);
    return SURE_HIT;
}

sure_status reference_compare_hit(const sure_ray *ray, const sure_object *object, double x,
                                  int *sign)
{
    const exact_hit hit = find_hit(*ray, *object);
    if (hit.status == SURE_HIT && sign)
        *sign = is_finite(x) ? compare(*hit.t, to_dyadic(x)) : order_key(x) < 0 ? 1 : -1;
    return hit.status;
}

sure_status reference_hit_within(const sure_ray *ray, const sure_object *object, double t,
                                 double error, int *is_within)
{
    const exact_hit hit = find_hit(*ray, *object);
    if (hit.status == SURE_HIT && is_within)
        *is_within = within(*hit.t, t, error);
    return hit.status;
}

sure_status reference_normal_within(const sure_ray *ray, const sure_object *object,
                                    sure_vec3 normal, double error, int *is_within)
{
    const exact_hit hit = find_hit(*ray, *object);
    if (hit.status != SURE_HIT || !is_within)
        return hit.status;
    const unit_vector n = hit.about->normal(*hit.t);
    *is_within = within(n[0], normal.x, error) && within(n[1], normal.y, error) &&
                 within(n[2], normal.z, error);
    return SURE_HIT;
}

uint64_t reference_ulps(double a, double b)
{
    if (is_nan(a) || is_nan(b))
        return UINT64_MAX;
    const int64_t from = order_key(a), to = order_key(b);
    return from < to ? static_cast<uint64_t>(to) - static_cast<uint64_t>(from)
                     : static_cast<uint64_t>(from) - static_cast<uint64_t>(to);
}

sure_status reference_decide(const sure_ray *ray, const sure_object *object,
                             reference_decisions *decisions)
{
    if (reference_check(ray, object) != SURE_FIELD_NONE)
        return SURE_INVALID;
    if (decisions)
        *decisions = ask(*ray, *object)->decisions();
    return SURE_HIT;
}

int reference_wall_side(const sure_ray *ray, const sure_object *object)
{
    const std::unique_ptr<question> about = ask(*ray, *object);
    const quadratic *wall = about->wall();
    if (!wall)
        contradiction("an object without a wall");
    const real start = about->on().at(to_dyadic(ray->t_min));
    const integer n = start.numerator.a0(), d = start.denominator;
    return (wall->a * square(n) + (wall->b + wall->b) * n * d + wall->c * square(d)).sign();
}

/* The points of the wall are its quadratic's roots, or the whole line where it vanishes. */
sure_status reference_wall_hit(const sure_ray *ray, const sure_object *object, double *t)
{
    if (reference_check(ray, object) != SURE_FIELD_NONE)
        return SURE_INVALID;
    const std::unique_ptr<question> about = ask(*ray, *object);
    const quadratic *wall = about->wall();
    if (!wall)
        contradiction("an object without a wall");
    if (wall->vanishes()) {
        if (t)
            *t = from_order_key(order_key(ray->t_min));
        return SURE_HIT;
    }
    for (const real &root : wall->roots(about->on())) {
        if (!on_ray(*ray, root))
            continue;
        if (t)
            *t = nearest(root);
        return SURE_HIT;
    }
    return SURE_MISS;
}
}

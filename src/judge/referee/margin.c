/* SPDX-License-Identifier: MIT */
#include "margin.h"

#include "../../numbers/sums.h"

#include <float.h>
#include <math.h>

const char *const margin_unit_names[] = {"none", "size",   "distance", "length",
                                         "ulps", "growth", NULL};

static double distance_of(const sure_case *question)
{
    const double *point = (const double *)(const void *)&question->object.as;
    const sure_vec3 *o = &question->ray.origin;
    return hypot(hypot(o->x - point[0], o->y - point[1]), o->z - point[2]);
}

static double largest_coordinate(const sure_case *question)
{
    sure_case copy = *question;
    double most = 0;
    for (int i = 0; i < case_numbers(copy.object.shape); i++) {
        if (case_number_kind(copy.object.shape, i) == IS_LENGTH)
            most = fmax(most, fabs(*case_number(&copy, i)));
    }
    return most;
}

double margin_length(const sure_case *question, margin_unit unit, precision in)
{
    double size = object_size(&question->object);
    switch (unit) {
    case MARGIN_GROWTH: /* a plane's */
    case MARGIN_SIZE: return size > 0 ? size : distance_of(question);
    case MARGIN_DISTANCE: return size + distance_of(question);
    case MARGIN_ULPS:
        return largest_coordinate(question) * (in == PRECISION_FLOAT ? 0x1p-23 : 0x1p-52);
    default: return 1;
    }
}

movement margin_way(const sure_case *question, margin_unit unit, precision in)
{
    bool grows = unit == MARGIN_GROWTH && sure_shape_info_of(question->object.shape)->bounded;
    return grows ? movement_of_growth(&question->object)
                 : movement_of_all(margin_length(question, unit, in));
}

fault margin_fault(unsigned faults)
{
    fault which = FAULT_FALSE_HIT;
    while (which <= FAULT_WRONG_PART && (faults & FAULT_BIT(which)) == 0)
        which++;
    return which;
}

/* Questions about the moved object. */

static bool is_hit(const sure_ray *ray, const sure_object *object)
{
    return sure_object_occluded(ray, object, SURE_TIER_EXACT) == SURE_HIT;
}

/* Is all of it in the interior of the closed solid, or of what the wall goes round? */
static bool is_within(const sure_case *solid, const sure_ray *ray)
{
    return !case_is_hit(solid, ray) && case_starts_within(solid, ray);
}

/* Has it a point of that? */
static bool meets(const sure_case *solid, const sure_ray *ray)
{
    return case_is_hit(solid, ray) || case_starts_within(solid, ray);
}

/* The question of the moved object, or of its wall. Two nappes that are moved are no double cone:
 * there is none. */
static bool moved_case(const sure_case *question, const movement *how, sure_case *to)
{
    *to = *question;
    return question->wall ? wall_moved(&question->object, how, &to->object)
                          : object_moved(&question->object, how, &to->object);
}

static bool is_solid(const sure_object *object)
{
    return sure_shape_info_of(object->shape)->solid;
}

/* Of queries for the closed solid: no smaller one is missed, no larger one met. */
static bool closed_beyond(const sure_case *question, bool said_hit, const movement *way)
{
    const movement how = movement_times(way, said_hit ? 1 : -1);
    sure_case moved;
    return moved_case(question, &how, &moved) && meets(&moved, &question->ray) != said_hit;
}

/* A solid's boundary of some size in between is met unless the range lies outside of the largest or
 * in the smallest; and one is missed unless it comes into the smallest and leaves the largest.
 * Where doubles can't tell a moved object, nothing is said against the answer. A wall likewise. */

static bool solid_beyond(const sure_case *question, bool said_hit, const movement *out)
{
    const movement in = movement_times(out, -1);
    const sure_ray *ray = &question->ray;
    sure_case larger, smaller;
    bool has_smaller = moved_case(question, &in, &smaller);
    if (!moved_case(question, out, &larger))
        return false;
    if (said_hit)
        return !meets(&larger, ray) || (has_smaller && is_within(&smaller, ray));
    return has_smaller && meets(&smaller, ray) && case_is_hit(&larger, ray);
}

static bool displaced(const sure_object *flat, double along, double rim, sure_object *moved)
{
    movement how = movement_of_all(rim);
    how.along = along;
    return object_moved(flat, &how, moved);
}

/* Does the ray's line run along the plane? */
static bool is_parallel(const sure_ray *ray, const sure_object *plane)
{
    sure_ray ahead = *ray, back;
    ahead.t_min = 0;
    ahead.t_max = INFINITY;
    back = ahead;
    back.direction = negate(ahead.direction);
    return !is_hit(&ahead, plane) && !is_hit(&back, plane);
}

/* Between two planes that a ray starts it crosses just one of them; where it runs along them, a
 * ray along the normal does. */
static bool starts_between(const sure_ray *ray, const sure_object *one, const sure_object *other)
{
    const double *normal = (const double *)(const void *)&one->as + 3;
    sure_ray ahead = *ray;
    ahead.t_max = INFINITY;
    if (is_parallel(ray, one)) {
        ahead.direction = (sure_vec3){normal[0], normal[1], normal[2]};
        ahead.t_min = 0;
    }
    return is_hit(&ahead, one) != is_hit(&ahead, other);
}

static bool flat_beyond(const sure_case *question, bool said_hit, double by)
{
    const sure_object *flat = &question->object;
    const sure_ray *ray = &question->ray;
    double rim = said_hit ? by : -by;
    sure_object front, back;
    sure_case slab = *question;
    if (!displaced(flat, by, rim, &front) || !displaced(flat, -by, rim, &back))
        return false;
    if (!said_hit)
        return is_hit(ray, &front) && is_hit(ray, &back);
    if (sure_shape_info_of(flat->shape)->bounded)
        return object_slab(flat, by, &slab.object) && !meets(&slab, ray);
    return !is_hit(ray, &front) && !is_hit(ray, &back) && !starts_between(ray, &front, &back);
}

/* The part that was named comes into its own where it lies farther in and all others farther out;
 * where nothing is left to hit, all of it happened within `by`. */
static bool part_beyond(const sure_case *question, int part, const movement *out)
{
    const sure_shape_info *info = sure_shape_info_of(question->object.shape);
    const movement in = movement_times(out, -1);
    movement how = *out;
    sure_object moved, smaller;
    sure_hit hit;
    for (int i = 0; i < info->part_count; i++) {
        if ((int)info->parts[i] == part)
            how.by[i] = in.by[i];
    }
    return object_moved(&question->object, &in, &smaller) && is_hit(&question->ray, &smaller) &&
           object_moved(&question->object, &how, &moved) &&
           sure_object_hit(&question->ray, &moved, SURE_TIER_EXACT, &hit) == SURE_HIT &&
           (int)hit.part != part;
}

/* A face stays where it has no distance from the middle, or where the unit has underflowed. */
static bool all_go(const sure_case *question, const movement *way)
{
    int going = 0, count = sure_shape_info_of(question->object.shape)->part_count;
    while (going < count && way->by[going] > 0)
        going++;
    return going == count;
}

bool margin_beyond(const sure_case *question, fault which, const reply *given, const movement *way)
{
    bool said_hit = which == FAULT_FALSE_HIT;
    if (question->wall)
        return which != FAULT_WRONG_PART && solid_beyond(question, said_hit, way);
    if (!all_go(question, way))
        return false;
    if (which == FAULT_WRONG_PART)
        return part_beyond(question, given->part, way);
    if (!is_solid(&question->object))
        return flat_beyond(question, said_hit, way->by[0]);
    return given->to == QUERY_INTERVAL || given->to == QUERY_INSIDE
               ? closed_beyond(question, said_hit, way)
               : solid_beyond(question, said_hit, way);
}

bool margin_beyond_length(const sure_case *question, fault which, const reply *given, double by)
{
    const movement way = movement_of_all(by);
    return margin_beyond(question, which, given, &way);
}

bool margin_of_end(const sure_case *question, double by)
{
    const movement out = movement_of_all(by), in = movement_of_all(-by);
    const sure_ray *ray = &question->ray;
    sure_ray start = *ray;
    sure_case solid = *question, larger, smaller;
    solid.wall = false;
    start.t_max = start.t_min;
    return by > 0 && is_solid(&question->object) && moved_case(&solid, &out, &larger) &&
           moved_case(&solid, &in, &smaller) && meets(&larger, &start) &&
           !is_within(&smaller, &start) && meets(&smaller, ray) && case_is_hit(&larger, ray);
}

static bool beyond_times(const sure_case *question, fault which, const reply *given, double times,
                         const movement *unit)
{
    const movement way = movement_times(unit, times);
    return margin_beyond(question, which, given, &way);
}

/* Doubled until it is too much, or halved until it is not; then halved between, unless doubles have
 * nothing there. What is tried depends on `least` and `below` alone. */
double margin_of(const sure_case *question, fault which, const reply *given, double least,
                 double below, double enough, const movement *unit)
{
    double low = least, high = least;
    if (below <= MARGIN_MOST) {
        for (high = below; high > enough && high / 2 > least; high /= 2) {
            if (beyond_times(question, which, given, high / 2, unit))
                break;
        }
        low = fmax(high / 2, least);
    } else {
        do {
            low = high;
            high = fmin(2 * low, MARGIN_MOST);
        } while (high > low && beyond_times(question, which, given, high, unit));
    }
    while (high - low > low / 16 && high > enough) {
        double middle = low + (high - low) / 2;
        if (middle == low || middle == high)
            break;
        if (beyond_times(question, which, given, middle, unit))
            low = middle;
        else
            high = middle;
    }
    return low;
}

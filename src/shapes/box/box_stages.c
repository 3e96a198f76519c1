/* SPDX-License-Identifier: MIT */
/* The box for certain and exact: what it gives to the stages, and what is asked of a hit. And
 * stable's guess: as textbook has it. */
#include "../../numbers/ddb.h"
#include "../../numbers/mod128_value.h"
#include "../../numbers/valid.h"
#include "../../stages/hits/normal.h"
#include "../bounds.h"
#include "../planar/planar_stages.h"
#include "../stable.h"
#include "box_filter.h"
#include "box_slabs.h"

/* n / d is t at a face: of two faces, n d' - n' d. */
#define BOX_AHEAD(number)                                                                          \
    static inline number ahead_##number(number##_context *c, const sure_ray *ray,                  \
                                        const sure_box *box, int face, int other)                  \
    {                                                                                              \
        const sure_vec3 *o = &ray->origin, *d = &ray->direction;                                   \
        number n = number##_difference_of(c, box_place(box, face), box_along(o, face));            \
        number m = number##_difference_of(c, box_place(box, other), box_along(o, other));          \
        return number##_minor(c, n, number##_of(c, box_along(d, face)), m,                         \
                              number##_of(c, box_along(d, other)));                                \
    }
BOX_AHEAD(ddb)
BOX_AHEAD(mod128)
BOX_AHEAD(exact)

/* The line's interval by the order of its crossings with the faces' planes, whatever tells that
 * order: the sign of t - t' of two faces that the line crosses. */
typedef struct box_line box_line;
struct box_line {
    const sure_ray *ray;
    const sure_box *box;
    int (*order)(box_line *, int face, int other);
    ddb_context near;
    exact_context *exact;
    int enter, leave; /* the faces that the ends are on */
};

static int sign_of_step(const box_line *l, int face)
{
    return is_negative_bits(box_along(&l->ray->direction, face)) ? -1 : 1;
}

static int order_exactly(box_line *l, int face, int other)
{
    return exact_sign(l->exact, ahead_exact(l->exact, l->ray, l->box, face, other)) *
           sign_of_step(l, face) * sign_of_step(l, other);
}

/* By double-doubles, then by the low bits. */
static int order_nearly(box_line *l, int face, int other)
{
    ddb_context c = {false};
    ddb ahead = ahead_ddb(&c, l->ray, l->box, face, other);
    int sign = ddb_sign(&c, ahead);
    if (c.uncertain)
        c.uncertain =
            !mod128_sign(ddb_most(ahead), ahead_mod128(NULL, l->ray, l->box, face, other), &sign);
    l->near.uncertain |= c.uncertain;
    return sign * sign_of_step(l, face) * sign_of_step(l, other);
}

/* Along an axis that the line does not go: the face in whose plane it is, 6 for none, -1 where it
 * is outside. */
static int face_along(const box_line *l, int axis)
{
    int64_t o = place_of(box_along(&l->ray->origin, 2 * axis));
    int64_t low = place_of(box_place(l->box, 2 * axis));
    int64_t high = place_of(box_place(l->box, 2 * axis + 1));
    if (o < low || o > high)
        return -1;
    return o == low ? 2 * axis : o == high ? 2 * axis + 1 : 6;
}

static int lesser(int face, int other)
{
    return face < other ? face : other;
}

static tagged_interval interval_of(box_line *l)
{
    int within = 6; /* the first face that all of the line is in */
    l->enter = l->leave = -1;
    for (int axis = 0; axis < 3; axis++) {
        double d = box_along(&l->ray->direction, 2 * axis);
        if (is_zero_bits(d)) {
            int face = face_along(l, axis);
            if (face < 0) {
                l->enter = l->leave = -1; /* no order decides */
                return interval_empty();
            }
            within = lesser(within, face);
            continue;
        }
        int near = 2 * axis + is_negative_bits(d), far = near ^ 1;
        if (l->enter < 0 || l->order(l, near, l->enter) > 0)
            l->enter = near;
        if (l->leave < 0 || l->order(l, far, l->leave) < 0)
            l->leave = far;
    }
    int apart = l->order(l, l->leave, l->enter);
    if (apart < 0)
        return interval_empty();
    tagged_end enter = {END_BASE, box_part(lesser(within, l->enter))};
    tagged_end leave = {END_TOP, box_part(lesser(within, l->leave))};
    if (apart == 0) {
        enter.part = enter.part < leave.part ? enter.part : leave.part;
        return interval_point(enter);
    }
    return within < 6 ? interval_along(enter, leave, box_part(within))
                      : interval_between(enter, leave);
}

/* t of a face's plane; known exactly where the ray starts there. */
static filter_end end_at(const box_line *l, int face, tagged_end tag)
{
    double o = box_along(&l->ray->origin, face), d = box_along(&l->ray->direction, face);
    double place = box_place(l->box, face), per_d = 1 / d;
    filter_end end = box_end((place - o) * per_d, face, tag.at);
    end.end.part = tag.part;
    if (same_number(place, o))
        end.t = end.error = 0;
    return end;
}

/* Is it known, and its error a share of it? */
static bool is_near(const filter_end *end)
{
    return filter_at_start(end) || fabs(end->t) > BOX_APART;
}

static bool interval_nearly(box_line *l, filter_interval *found, tagged_interval *ends)
{
    *ends = interval_of(l);
    if (l->near.uncertain)
        return false;
    if (ends->empty)
        return true;
    found->enter = end_at(l, l->enter, ends->enter);
    found->leave =
        ends->leave.at == ends->enter.at ? found->enter : end_at(l, l->leave, ends->leave);
    return is_near(&found->enter) && is_near(&found->leave);
}

/* Where the filter is uncertain: the same by a better order. */
static filter_verdict refine(const sure_ray *ray, const void *shape, bool both_ends,
                             filter_interval *found, sure_stage *stage)
{
    const sure_box *s = shape;
    box_line l = {.ray = ray, .box = s, .order = order_nearly};
    tagged_interval ends;
    bool told;
    *stage = SURE_STAGE_MOD128;
    if (!box_in_range(ray, s) || !corners_ok(s->low, s->high))
        return FILTER_UNCERTAIN;
    TO_NEAREST(told, interval_nearly(&l, found, &ends));
    if (!told)
        return FILTER_UNCERTAIN;
    if (ends.empty)
        return filter_miss_if(true, ray);
    return ends.boundary ? planar_chord(ends.inner_part, ray, both_ends, found) : FILTER_INTERVAL;
}

/* The planes that the ends are on, over one divisor; where it leaves before it enters, too. */
static tagged_interval exact_interval(exact_context *c, const sure_ray *ray, const void *shape,
                                      line_coefficients *l)
{
    const sure_box *s = shape;
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    box_line line = {.ray = ray, .box = s, .order = order_exactly, .exact = c};
    tagged_interval ends = interval_of(&line);
    if (line.enter < 0)
        return ends;
    exact in = exact_of(c, box_along(d, line.enter)), out = exact_of(c, box_along(d, line.leave));
    l->speed = exact_mul(c, in, out);
    l->base = exact_mul(
        c, exact_difference_of(c, box_place(s, line.enter), box_along(o, line.enter)), out);
    l->top = exact_mul(
        c, exact_difference_of(c, box_place(s, line.leave), box_along(o, line.leave)), in);
    return ends;
}

static sure_vec3 round_normal(exact_context *c, const sure_ray *ray, const void *shape,
                              const line_coefficients *l, tagged_end at)
{
    (void)c, (void)ray, (void)shape, (void)l;
    return box_outward(at.part);
}

const shape_row box_row = {
    .info = {.name = "box",
             .solid = 1,
             .bounded = 1,
             .numbers = 6,
             .field_count = 2,
             .part_count = 6,
             .fields = {{SURE_FIELD_LOW, SURE_KIND_POINT, DOUBLES_BEFORE(sure_box, low)},
                        {SURE_FIELD_HIGH, SURE_KIND_HIGH, DOUBLES_BEFORE(sure_box, high)}},
             .parts = {SURE_PART_X_MIN, SURE_PART_X_MAX, SURE_PART_Y_MIN, SURE_PART_Y_MAX,
                       SURE_PART_Z_MIN, SURE_PART_Z_MAX}},
    .shape = SURE_SHAPE_BOX,
    .filter = box_filter,
    .refine = refine,
    .steps = 1,
    .exact_interval = exact_interval,
    .round_normal = round_normal,
    .surface = &box_surface_row,
};

sure_status sure_box_hit_certain(const sure_ray *ray, const sure_box *box, sure_hit *hit)
{
    const decided said = box_decide(ray, box);
    return said.certain ? decision_tell(&said, hit) : stages_certain_rest(ray, box, hit, &box_row);
}

STAGES_QUESTIONS(box)

static span box_guess(const sure_ray *ray, const void *shape)
{
    return box_span(ray, shape);
}

STABLE_QUESTIONS(box)

/* What is asked of a hit. */

static bool part_of_plane(const void *shape, sure_part part, part_plane *plane)
{
    const sure_box *s = shape;
    *plane = (part_plane){.to = box_outward(part), .at = box_face(part) % 2 ? s->high : s->low};
    return true;
}

/* Of one coordinate: 1 outside, 0 on a face, -1 between. */
static int side_along(double x, double low, double high)
{
    int64_t p = place_of(x), least = place_of(low), most = place_of(high);
    return p < least || p > most ? 1 : p == least || p == most ? 0 : -1;
}

static int side_of(const void *shape, sure_vec3 p)
{
    const sure_box *s = shape;
    int across =
        number_side(side_along(p.x, s->low.x, s->high.x), side_along(p.y, s->low.y, s->high.y));
    return number_side(across, side_along(p.z, s->low.z, s->high.z));
}

/* The comparison may take subnormals for 0, and spares most the other one. */
static inline bool is_flat_along(const sure_box *s, int axis)
{
    double low = box_place(s, 2 * axis), high = box_place(s, 2 * axis + 1);
    return !(low < high) && same_number(low, high);
}

static bool has_inside(const void *shape)
{
    return !is_flat_along(shape, 0) && !is_flat_along(shape, 1) && !is_flat_along(shape, 2);
}

/* Across the first axis that it is flat along and the ray is not. */
static bool flat_part(const void *shape, const sure_vec3 *d, sure_part *part)
{
    bool flat = false;
    for (int axis = 0; axis < 3; axis++) {
        double along = box_along(d, 2 * axis);
        if (!is_flat_along(shape, axis))
            continue;
        flat = true;
        if (is_zero_bits(along))
            continue;
        *part = box_part(2 * axis + is_negative_bits(along));
        return true;
    }
    return flat;
}

static sure_vec3 outward(const void *shape, sure_part part, sure_vec3 p)
{
    (void)shape, (void)p;
    return box_outward(part);
}

static void bounds(const void *shape, double low[3], double high[3])
{
    const sure_box *s = shape;
    const double reach[3] = {0, 0, 0};
    bounds_include(s->low, reach, low, high);
    bounds_include(s->high, reach, low, high);
}

const surface_row box_surface_row = {
    .plane = part_of_plane,
    .side = side_of,
    .has_inside = has_inside,
    .flat_part = flat_part,
    .outward = outward,
    .bounds = bounds,
};

static inline bool box_quick_normal(const sure_ray *ray, const sure_box *box, const sure_hit *hit,
                                    sure_vec3 *normal)
{
    (void)ray, (void)box;
    *normal = box_outward(hit->part);
    return true;
}

SURFACE_NORMALS(box)

/* SPDX-License-Identifier: MIT */
/* What the first stages answer without a branch, since whether there is a hit is as good as random:
 * several queries side by side behind lanes.h, else one. */
#pragma once

#include "../capped/axial_filter.h"
#include "../plane/plane_filter.h"

/* What is certain and no hit is a miss. */
typedef struct {
    bool certain, hits;
    double t, error;
    uint64_t part;
    bool leaves;
} lanes_answer;

typedef struct {
    double t, error;
    uint64_t part;
} lanes_end;

/* <shape>_lanes_miss where nothing is told before an end is: it is not asked. */
#define LANES_NO_MISS(ray, object) ((void)(ray), (void)(object), (bool){0})

/* A shape's question is begun and ended; where <shape>_ends_later, others are begun between, which
 * need not wait for what takes long. Where <shape>_looks_closely, what is uncertain is looked at
 * once more. Here all is told at once. */
#define LANES_AT_ONCE(shape)                                                                       \
    enum { shape##_ends_later = 0, shape##_looks_closely = 0 };                                    \
    typedef lanes_answer shape##_begun;                                                            \
    static inline shape##_begun shape##_begin(const sure_ray *ray, const sure_##shape *object)     \
    {                                                                                              \
        return shape##_lanes(ray, object);                                                         \
    }                                                                                              \
    static inline lanes_answer shape##_end(const sure_ray *ray, const shape##_begun *begun)        \
    {                                                                                              \
        (void)ray;                                                                                 \
        return *begun;                                                                             \
    }                                                                                              \
    static inline lanes_answer shape##_lanes_closely(const sure_ray *ray,                          \
                                                     const sure_##shape *object)                   \
    {                                                                                              \
        return shape##_lanes(ray, object);                                                         \
    }

static inline double lanes_where(bool condition, double x, double y)
{
    return filter_either(filter_all(condition), x, y);
}

/* filter_first: of lines whose chord is certainly found or certainly none. */
static inline lanes_answer lanes_first(bool found, bool none, const lanes_end *enter,
                                       const lanes_end *leave, const sure_ray *ray)
{
    double t_min = ray->t_min, t_max = ray->t_max;
    bool valid = filter_range(ray);
    double to_enter = enter->t - t_min, to_leave = leave->t - t_min;
    bool ahead = to_enter > enter->error, behind = to_enter < -enter->error;
    bool leaving = to_leave > leave->error, left = to_leave < -leave->error;
    uint64_t first = filter_all(ahead);
    double t = filter_either(first, enter->t, leave->t);
    double error = filter_either(first, enter->error, leave->error);
    bool starts = ahead | (behind & leaving);
    bool meets = starts & (t_max - t > error), beyond = starts & (t_max - t < -error);
    return (lanes_answer){
        .certain = (none | (found & (meets | beyond | (behind & left)))) & valid,
        .hits = found & meets & valid,
        .t = t,
        .error = error,
        .part = filter_either_bits(first, enter->part, leave->part),
        .leaves = t > enter->t,
    };
}

static inline lanes_answer lanes_planar(const flat_decision *said)
{
    return (lanes_answer){
        .certain = said->certain,
        .hits = said->certain & said->meets,
        .t = said->at.t,
        .error = said->at.error,
        .part = (uint64_t){SURE_PART_SURFACE},
        .leaves = true ^ true,
    };
}

/* axial_decide. */
static inline lanes_answer lanes_capped(const axial_line *l, const axial_terms *of, double radius,
                                        const sure_ray *ray)
{
    double discriminant = axial_discriminant(of);
    bool certain = axial_is_certain(of, discriminant) & axial_fits(of, radius);
    axial_gaps gaps = axial_gaps_of(l);
    bool outside = discriminant < 0, apart = gaps.common < 0;
    uint64_t down = filter_mask(l->e);
    lanes_end enter = {filter_greater(axial_low(l), l->less), axial_end_error(l, gaps.before),
                       axial_end_part(gaps.before, ~down)};
    lanes_end leave = {filter_lesser(axial_high(l), l->more), axial_end_error(l, gaps.after),
                       axial_end_part(gaps.after, down)};
    return lanes_first(certain & (true ^ (outside | apart)) &
                           axial_meets(l, &gaps, of->d_d, of->size),
                       certain & (outside | (apart & axial_misses(l, &gaps))), &enter, &leave, ray);
}

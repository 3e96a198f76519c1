/* `certain` and `exact` as a list of stages. The first, the filter, is each shape's own
 * (<shape>_filter.h, <shape>_certain.c); what it leaves undecided goes on to the others, which take
 * any object. */
#ifndef STAGES_LADDER_H
#define STAGES_LADDER_H

#include "../numbers/environment.h"
#include "../shapes/filter.h"
#include "question.h"

#include <surehit/object.h>

#ifdef __GNUC__
#define LADDER_RARE __attribute__((noinline))
#else
#define LADDER_RARE
#endif

/* t within t_error, or correctly rounded. */
typedef enum { T_CERTAIN, T_EXACT } t_wanted;

/* The last stages, from *stage on; *stage tells which of them answered. Entry: valid input; what
 * question_of made of it, or NULL. */
sure_status ladder_hit(const sure_ray *ray, const sure_object *object, const question *asked,
                       t_wanted wanted, sure_hit *hit, sure_stage *stage);

/* All stages but the filter, for both ends of the chord. Entry: any input. */
sure_status ladder_interval(const sure_ray *ray, const sure_object *object, t_wanted wanted,
                            sure_interval *interval);

/* Entry for these three: the ray hits, and that part. */
sure_vec3 ladder_normal(const sure_ray *ray, const sure_object *object, sure_part part,
                        t_wanted wanted);
sure_vec3 ladder_point(const sure_ray *ray, const sure_object *object);
int ladder_order(const sure_ray *ray, const sure_object *first, const sure_object *second);

/* Half the step from t to its neighbour away from zero, or the least double. */
static inline double ladder_half_ulp(double t)
{
    int exponent = exponent_of(t);
    if (!is_finite_bits(t))
        return INFINITY;
    if (exponent > -969)
        return power_of_two(exponent - 53);
    return double_of(exponent < -1021 ? 1 : UINT64_C(1) << (exponent + 1021));
}

/* Have the chord and [t_min, t_max] a point in common? FILTER_CHORD when they certainly have. */
static inline filter_verdict filter_meets(const filter_chord *found, const sure_ray *ray)
{
    if (!filter_range(ray))
        return FILTER_UNCERTAIN;
    double before = found->enter.t - ray->t_max, after = ray->t_min - found->leave.t;
    if (before > found->enter.error || after > found->leave.error)
        return FILTER_MISS;
    return -before > found->enter.error && -after > found->leave.error ? FILTER_CHORD
                                                                       : FILTER_UNCERTAIN;
}

/* Two ends that lie closer than they are known may come out in the wrong order; then the first is
 * an approximation of both, as good as the worse of the two: enter* <= leave*, and enter* is no
 * farther below it than from t_enter, leave* no farther above it than from t_leave. */
static inline void ladder_order_ends(sure_interval *interval)
{
    if (interval->t_leave < interval->t_enter)
        interval->t_leave = interval->t_enter;
}

/* By filter and ladder together: the stage that answers sure_<shape>_hit_*. */
sure_stage ladder_plane_stage(const sure_ray *ray, const sure_plane *plane, t_wanted wanted);
sure_stage ladder_disc_stage(const sure_ray *ray, const sure_disc *disc, t_wanted wanted);
sure_stage ladder_sphere_stage(const sure_ray *ray, const sure_sphere *sphere, t_wanted wanted);
sure_stage ladder_cylinder_stage(const sure_ray *ray, const sure_cylinder *cylinder,
                                 t_wanted wanted);
sure_stage ladder_cone_stage(const sure_ray *ray, const sure_cone *cone, t_wanted wanted);

#endif

#include "wide_stages.h"

#include "../numbers/near.h"
#include "solve.h"

#include <surehit/bounds.h>

static sure_vec3 difference(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static double square(sure_vec3 v)
{
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

/* |o - object|^2 + size^2, not more than (|o - object| + size)^2. */
static double reach_square(const question *q)
{
    const sure_object *object = q->object;
    sure_vec3 o = q->ray->origin;
    switch (object->shape) {
    case SURE_SHAPE_PLANE: return square(difference(o, object->as.plane.point));
    case SURE_SHAPE_DISC: {
        double r = object->as.disc.radius;
        return square(difference(o, object->as.disc.centre)) + r * r;
    }
    case SURE_SHAPE_SPHERE: {
        double r = object->as.sphere.radius;
        return square(difference(o, object->as.sphere.centre)) + r * r;
    }
    case SURE_SHAPE_CYLINDER: {
        const sure_cylinder *s = &object->as.cylinder;
        return square(difference(o, s->base)) + square(difference(s->top, s->base)) +
               s->radius * s->radius;
    }
    case SURE_SHAPE_CONE: break;
    }
    const sure_cone *s = &object->as.cone;
    return square(difference(o, s->base)) + square(difference(s->apex, s->base)) +
           s->radius * s->radius;
}

/* Is the error within its cap, t_error |d| <= SURE_T_ERROR_CAP (|o - object| + size)? Some ten
 * roundings are made good by 2^-40. */
static bool within_cap(const question *q, double error)
{
    double limit = SURE_T_ERROR_CAP * SURE_T_ERROR_CAP * (1 - 0x1p-40) * reach_square(q);
    return error * error * square(q->ray->direction) <= limit;
}

/* t as wanted and the bound of its error. */
static bool t_as_wanted(const question *q, near t, t_wanted wanted, double *result, double *error)
{
    if (near_is_zero(t)) {
        *result = *error = 0;
        return true;
    }
    double bound = (t.error + fabs(t.lo)) * (1 + 0x1p-40);
    double known = fmax(bound, fabs(t.hi) * 0x1p-60); /* none far out of the range of doubles */
    if (!(wanted == T_EXACT ? wide_rounds_to(t, result) : within_cap(q, bound)))
        return false;
    return question_unscale(q, t.hi, result) && question_unscale(q, known, error);
}

static bool hit_as_wanted(const question *q, const solved_hit *found, t_wanted wanted,
                          sure_hit *hit)
{
    double t_min = q->asked->t_min, t_max = q->asked->t_max;
    hit->part = found->end.part;
    if (found->end.at == POINT_START) {
        hit->t = fabs(t_min);
        hit->t_error = 0;
        return true;
    }
    if (!t_as_wanted(q, found->t, wanted, &hit->t, &hit->t_error))
        return false;
    if (wanted == T_EXACT)
        hit->t_error = ladder_half_ulp(hit->t);
    hit->t = hit->t < t_min ? t_min : hit->t > t_max ? t_max : hit->t;
    return true;
}

bool wide_hit(const question *q, t_wanted wanted, sure_status *status, sure_hit *hit,
              sure_stage *stage)
{
    bool (*const stages[])(const sure_ray *, const sure_object *,
                           solved_hit *) = {solve_hit_near, solve_hit_residue};
    for (int i = *stage == SURE_STAGE_RESIDUE; i < 2; i++) {
        solved_hit found;
        sure_hit answer;
        if (!stages[i](q->ray, q->object, &found))
            continue;
        if (found.status == SURE_HIT) {
            if (!hit_as_wanted(q, &found, wanted, &answer))
                continue;
            *hit = answer;
        }
        *status = found.status;
        *stage = (sure_stage)(SURE_STAGE_DOUBLE_DOUBLE + i);
        return true;
    }
    return false;
}

static bool end_as_wanted(const question *q, point at, near t, t_wanted wanted, double endless,
                          double *result)
{
    double error;
    if (at != POINT_ENDLESS)
        return t_as_wanted(q, t, wanted, result, &error);
    *result = endless;
    return true;
}

bool wide_interval(const question *q, t_wanted wanted, sure_status *status, sure_interval *interval)
{
    bool (*const stages[])(const sure_ray *, const sure_object *,
                           solved_interval *) = {solve_interval_near, solve_interval_residue};
    for (int i = 0; i < 2; i++) {
        solved_interval found;
        if (!stages[i](q->ray, q->object, &found))
            continue;
        *status = found.status;
        if (found.status != SURE_HIT)
            return true;
        chord_end enter = found.ends.enter, leave = found.ends.leave;
        sure_interval answer = {.enter_part = enter.part, .leave_part = leave.part};
        if (!end_as_wanted(q, enter.at, found.t_enter, wanted, -INFINITY, &answer.t_enter) ||
            !end_as_wanted(q, leave.at, found.t_leave, wanted, INFINITY, &answer.t_leave))
            continue;
        ladder_order_ends(&answer);
        *interval = answer;
        return true;
    }
    return false;
}

/* SPDX-License-Identifier: MIT */
#include "event.h"

#include "margin.h"

#include <float.h>
#include <math.h>

const char *event_name(int which)
{
#define EVENT(NAME, name) name,
    static const char *const names[EVENTS] = {EACH_EVENT(EVENT)};
    return names[which];
}

static bool is_hit_within(const sure_case *question, double t_min, double t_max)
{
    sure_ray part = question->ray;
    part.t_min = t_min;
    part.t_max = t_max;
    return case_is_hit(question, &part);
}

/* Has the closed object the point at t? */
static bool is_met_at(const sure_case *question, double t)
{
    sure_ray at = question->ray;
    at.t_min = at.t_max = t;
    return case_starts_within(question, &at);
}

static bool is_at_end(const sure_case *question)
{
    double t_min = question->ray.t_min, t_max = question->ray.t_max;
    return t_max > t_min && t_max <= DBL_MAX &&
           !is_hit_within(question, t_min, nextafter(t_max, -INFINITY));
}

/* A wall's first hit is t, from outside: then the next double is no interior point. */
static bool is_wall_touch(const sure_case *question, double t)
{
    double next = nextafter(t, INFINITY);
    return !is_met_at(question, next) || is_hit_within(question, next, next);
}

/* Of a flat shape the line lies in it, or it is missed once the rim is one double less. */
static bool is_touch(const sure_case *question)
{
    const movement in = movement_of_all(-DBL_MIN);
    sure_interval ends;
    sure_object smaller;
    (void)sure_object_interval(&question->ray, &question->object, SURE_TIER_EXACT, &ends);
    double first = fmax(ends.t_enter, 0), next = nextafter(first, INFINITY);
    if (sure_shape_info_of(question->object.shape)->solid)
        return ends.t_leave <= next || is_hit_within(question, next, next);
    if (ends.t_leave > ends.t_enter || !sure_shape_info_of(question->object.shape)->bounded)
        return ends.t_leave > ends.t_enter;
    return !object_moved(&question->object, &in, &smaller) ||
           sure_object_occluded(&question->ray, &smaller, SURE_TIER_EXACT) != SURE_HIT;
}

event event_of(const sure_case *question, const case_answer *truth, fault which, const reply *given)
{
    double t_min = question->ray.t_min;
    if (is_met_at(question, t_min))
        return is_hit_within(question, t_min, t_min) ? EVENT_SURFACE : EVENT_INSIDE;
    if (truth->status == SURE_HIT && is_at_end(question))
        return EVENT_END;
    if (truth->status == SURE_HIT &&
        (question->wall ? is_wall_touch(question, truth->t) : is_touch(question)))
        return EVENT_TOUCH;
    if (!question->wall && which == FAULT_WRONG_PART &&
        !margin_beyond_length(question, which, given, DBL_MIN))
        return EVENT_TIE;
    return EVENT_CLEAR;
}

/* SPDX-License-Identifier: MIT */
#include "conventions.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *convention_name(convention which)
{
#define CONVENTION(NAME, name) name,
    static const char *const names[CONVENTIONS] = {EACH_CONVENTION(CONVENTION)};
    return names[which];
}

/* Of radius 1, from the origin 2 up; a box from the origin to (2, 2, 2). */
static sure_case unit_object(sure_shape shape)
{
    sure_case made = {.ray = {{0, 0, 0}, {1, 0, 0}, 0, INFINITY}, .object.shape = shape};
    const sure_shape_info *info = sure_shape_info_of(shape);
    for (int i = 0; i < info->field_count; i++) {
        double *at = case_number(&made, AT_OBJECT + info->fields[i].at);
        sure_kind kind = info->fields[i].kind;
        if (kind == SURE_KIND_RADIUS)
            at[0] = 1;
        if (kind == SURE_KIND_HIGH)
            at[0] = at[1] = 2;
        if (kind == SURE_KIND_OTHER_POINT || kind == SURE_KIND_HIGH || kind == SURE_KIND_NORMAL)
            at[2] = 2;
    }
    return made;
}

/* Bounds are wider by roundings. */
static sure_vec3 middle_of(const sure_case *object)
{
    sure_vec3 low, high;
    sure_object_bounds(&object->object, &low, &high);
    return (sure_vec3){rint(low.x + high.x) / 2, rint(low.y + high.y) / 2,
                       rint(low.z + high.z) / 2};
}

/* Where a ray against x meets a solid's middle; of a flat object the origin. */
static sure_vec3 point_on(const sure_case *object)
{
    sure_case along = *object;
    sure_hit hit;
    if (!sure_shape_info_of(object->object.shape)->solid)
        return (sure_vec3){0, 0, 0};
    along.ray.origin = middle_of(object);
    along.ray.origin.x += 8;
    along.ray.direction.x = -1;
    (void)sure_object_hit(&along.ray, &along.object, SURE_TIER_EXACT, &hit);
    along.ray.origin.x -= hit.t;
    return along.ray.origin;
}

static sure_ray ray_for(convention which, bool solid, sure_vec3 at)
{
    sure_vec3 out = solid ? (sure_vec3){1, 0, 0} : (sure_vec3){0, 0, 1};
    sure_vec3 in = {-out.x, 0, -out.z};
    sure_ray ray = {at, out, 0, INFINITY};
    switch (which) {
    case CONVENTION_TOUCH:
        return solid ? (sure_ray){{at.x, at.y - 8, at.z}, {0, 1, 0}, 0, INFINITY}
                     : (sure_ray){{1, 0, 4}, in, 0, INFINITY};
    case CONVENTION_INSIDE: ray.origin.x = at.x - 0.25; return ray;
    case CONVENTION_INWARD: ray.direction = in; return ray;
    case CONVENTION_END: return (sure_ray){{at.x + 4 * out.x, at.y, at.z + 4 * out.z}, in, 0, 4};
    default: return ray;
    }
}

/* As the candidate receives it. */
static bool case_of(const entry *by, sure_shape shape, convention which, precision in,
                    sure_case *question)
{
    static const event events[] = {EVENT_TOUCH, EVENT_INSIDE, EVENT_SURFACE, EVENT_SURFACE,
                                   EVENT_END};
    const sure_shape_info *info = sure_shape_info_of(shape);
    const reply none = {.status = SURE_MISS};
    sure_case made = unit_object(shape);
    made.ray = ray_for(which, info->solid, point_on(&made));
    if (!entry_case(by, &made, in, question))
        return false;
    case_answer right = case_answer_of(question, SURE_TIER_EXACT);
    return right.status == SURE_HIT &&
           event_of(question, &right, FAULT_FALSE_MISS, &none) == events[which];
}

/* Of t_min, the hit and the exit the one that is nearest. */
static const char *place_of(const example *one, double t)
{
    double t_min = one->question.ray.t_min, right = one->truth.t;
    sure_interval ends = {0};
    (void)sure_object_interval(&one->question.ray, &one->question.object, SURE_TIER_EXACT, &ends);
    double exit = ends.t_leave > ends.t_enter ? ends.t_leave : INFINITY;
    double off = fmin(fabs(t - t_min), fmin(fabs(t - right), fabs(t - exit)));
    return off == fabs(t - t_min) ? "0" : off == fabs(t - exit) ? "exit" : "hit";
}

static void say(const example *one, const reply *given, char word[32])
{
    char line[CASE_LINE_MAX];
    if (given->kind != REPLY_ANSWERED || given->status == SURE_INVALID) {
        reply_print(given, line);
        line[strcspn(line, ":,")] = '\0'; /* what exactly the worst cases say */
        snprintf(word, 32, "%.31s", line);
    } else if (given->status == SURE_MISS || given->to == QUERY_OCCLUDED) {
        snprintf(word, 32, "%s", given->status == SURE_MISS ? "miss" : "hit");
    } else {
        snprintf(word, 32, "%s", isfinite(given->t) ? place_of(one, given->t) : "no number");
    }
}

bool conventions_ask(judging *self, sure_shape shape, convention_words *said)
{
    const candidate *asked = judging_asked(self);
    query asks = judging_asks(self, QUERY_HIT, shape) ? QUERY_HIT : QUERY_OCCLUDED;
    sure_case questions[CONVENTIONS];
    example answered[CONVENTIONS];
    int list[CONVENTIONS], count = 0;
    *said = (convention_words){0};
    if (!judging_asks(self, asks, shape))
        return false;
    for (int i = 0; i < CONVENTIONS; i++) {
        if (case_of(&asked->entry, shape, (convention)i, asked->answers_in[asks][shape],
                    &questions[count]))
            list[count++] = i;
    }
    if (count > 0 && !judging_several(self, asks, questions, count, answered))
        return false;
    for (int i = 0; i < count; i++) {
        const reply *given = &answered[i].given;
        const reply right = reply_of(&answered[i].truth, given->to);
        say(&answered[i], given, said->candidate[list[i]]);
        say(&answered[i], &right, said->contract[list[i]]);
    }
    return true;
}

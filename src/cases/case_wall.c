/* SPDX-License-Identifier: MIT */
/* Questions about the object of a case or about its infinite wall. */
#include "shapes/case_shape.h"

static const case_shape *row_of(const sure_case *question)
{
    return case_shape_of(question->object.shape);
}

bool case_has_wall(sure_shape shape)
{
    return case_shape_of(shape)->wall_hit != NULL;
}

bool case_is_hit(const sure_case *question, const sure_ray *ray)
{
    const sure_object *object = &question->object;
    sure_hit unused;
    sure_status status = question->wall ? row_of(question)->wall_hit(ray, &object->as, &unused)
                                        : sure_object_occluded(ray, object, SURE_TIER_EXACT);
    return status == SURE_HIT;
}

bool case_starts_within(const sure_case *question, const sure_ray *ray)
{
    sure_interval unused;
    sure_ray start = *ray;
    start.t_max = start.t_min;
    if (question->wall)
        return sure_object_check(&start, &question->object) == SURE_FIELD_NONE &&
               row_of(question)->wall_side(&start, &question->object.as) <= 0;
    return sure_object_interval(&start, &question->object, SURE_TIER_EXACT, &unused) == SURE_HIT;
}

case_answer case_wall_answer(const sure_case *question)
{
    sure_hit hit = {.t = 0};
    case_answer answer = {
        .status = row_of(question)->wall_hit(&question->ray, &question->object.as, &hit)};
    answer.t = hit.t;
    answer.part = hit.part;
    if (answer.status == SURE_INVALID)
        answer.field = sure_object_check(&question->ray, &question->object);
    return answer;
}

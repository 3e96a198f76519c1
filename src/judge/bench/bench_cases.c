/* SPDX-License-Identifier: MIT */
#include "bench_cases.h"

#include "../../numbers/sums.h"

#include <math.h>
#include <string.h>

static double length_of(sure_vec3 v)
{
    return sqrt(dot(v, v));
}

/* Half an object's extent, or nearly so. */
static double size_of(const sure_case *c)
{
    const sure_shape_info *info = sure_shape_info_of(c->object.shape);
    sure_case of = *c;
    double size = 0;
    for (int i = 0; i < info->field_count; i++) {
        const sure_vec3 *x = case_vector(&of, AT_OBJECT + info->fields[i].at);
        if (info->fields[i].kind == SURE_KIND_RADIUS)
            return x->x;
        if (info->fields[i].kind == SURE_KIND_HIGH)
            size = length_of(difference_of(*x, *case_vector(&of, AT_OBJECT))) / 2;
    }
    return size > 0 ? size : 1;
}

bool case_same_object(const sure_case *a, const sure_case *b)
{
    const sure_shape shape = a->object.shape;
    const size_t size = (size_t)sure_shape_info_of(shape)->numbers * sizeof(double);
    return shape == b->object.shape && memcmp(&a->object.as, &b->object.as, size) == 0;
}

sure_case case_before_object(const sure_case *c, const sure_object *to)
{
    sure_case made = {.ray = c->ray, .object = *to}, from = *c;
    const double scale = size_of(&made) / size_of(c);
    const sure_vec3 away = difference_of(c->ray.origin, *case_vector(&from, AT_OBJECT));
    made.ray.origin = sum_of(*case_vector(&made, AT_OBJECT), scale, away);
    made.ray.direction = scaled(scale, c->ray.direction);
    return made;
}

/* x in the mirror that maps one of two unit vectors to the other; w is their difference. */
static sure_vec3 mirrored(sure_vec3 x, sure_vec3 w)
{
    const double w_w = dot(w, w);
    return w_w > 0 ? sum_of(x, -2 * dot(x, w) / w_w, w) : x;
}

sure_case case_before_ray(const sure_case *c, const sure_ray *to)
{
    sure_case made = {.object = c->object}, from = *c;
    const sure_shape_info *info = sure_shape_info_of(c->object.shape);
    const double length = length_of(c->ray.direction), wanted = length_of(to->direction);
    const double scale = wanted / length;
    made.ray = (sure_ray){to->origin, to->direction, 0, INFINITY};
    const sure_vec3 w =
        difference_of(scaled(1 / length, c->ray.direction), scaled(1 / wanted, to->direction));
    for (int i = 0; i < info->field_count; i++) {
        sure_vec3 *x = case_vector(&made, AT_OBJECT + info->fields[i].at);
        const sure_vec3 *first = case_vector(&from, AT_OBJECT);
        switch (info->fields[i].kind) {
        case SURE_KIND_RADIUS: x->x *= scale; break;
        case SURE_KIND_NORMAL: *x = mirrored(*x, w); break;
        case SURE_KIND_HIGH:
            *x = sum_of(*case_vector(&made, AT_OBJECT), scale, difference_of(*x, *first));
            break;
        case SURE_KIND_POINT:
        case SURE_KIND_OTHER_POINT:
            *x = sum_of(to->origin, scale, mirrored(difference_of(*x, c->ray.origin), w));
            break;
        }
    }
    return made;
}

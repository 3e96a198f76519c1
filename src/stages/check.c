/* SPDX-License-Identifier: MIT */
#include "shape.h"
#include "../numbers/valid.h"

sure_field sure_ray_check(const sure_ray *ray)
{
    if (!all_finite(ray->origin))
        return SURE_FIELD_O;
    if (!direction_ok(ray->direction))
        return SURE_FIELD_D;
    if (!(is_finite_bits(ray->t_min) && not_negative(ray->t_min)))
        return SURE_FIELD_T_MIN;
    if (!(magnitude_bits(ray->t_max) <= BITS_INFINITY && not_negative(ray->t_max) &&
          magnitude_bits(ray->t_max) >= magnitude_bits(ray->t_min)))
        return SURE_FIELD_T_MAX;
    return SURE_FIELD_NONE;
}

static bool field_ok(const double *numbers, const double *place, sure_kind kind)
{
    const sure_vec3 *first = (const sure_vec3 *)numbers, *vector = (const sure_vec3 *)place;
    switch (kind) {
    case SURE_KIND_POINT: return all_finite(*vector);
    case SURE_KIND_OTHER_POINT: return all_finite(*vector) && !same_point(*vector, *first);
    case SURE_KIND_HIGH: return corners_ok(*first, *vector);
    case SURE_KIND_NORMAL: return direction_ok(*vector);
    case SURE_KIND_RADIUS: break;
    }
    return radius_ok(*place);
}

sure_field shape_check(const shape_row *row, const sure_ray *ray, const void *shape)
{
    sure_field bad = sure_ray_check(ray);
    const double *numbers = shape;
    for (int i = 0; i < row->info.field_count && bad == SURE_FIELD_NONE; i++) {
        const sure_shape_field *field = &row->info.fields[i];
        if (!field_ok(numbers, numbers + field->at, field->kind))
            bad = field->name;
    }
    return bad;
}

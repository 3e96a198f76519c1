#include "check.h"

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

static bool field_ok(const shape_row *row, const void *shape, const shape_field *field)
{
    const void *place = (const char *)shape + field->offset;
    const sure_vec3 *first = (const sure_vec3 *)((const char *)shape + row->fields[0].offset);
    switch (field->kind) {
    case FIELD_POINT: return all_finite(*(const sure_vec3 *)place);
    case FIELD_OTHER_POINT:
        return all_finite(*(const sure_vec3 *)place) &&
               !same_point(*(const sure_vec3 *)place, *first);
    case FIELD_NORMAL: return direction_ok(*(const sure_vec3 *)place);
    case FIELD_RADIUS: break;
    }
    return radius_ok(*(const double *)place);
}

sure_field shape_check(const shape_row *row, const sure_ray *ray, const void *shape)
{
    sure_field bad = sure_ray_check(ray);
    for (int i = 0; i < row->field_count && bad == SURE_FIELD_NONE; i++) {
        if (!field_ok(row, shape, &row->fields[i]))
            bad = row->fields[i].name;
    }
    return bad;
}

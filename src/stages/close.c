/* SPDX-License-Identifier: MIT */
#include "close.h"

#include "../numbers/environment.h"

bool close_polish(const shape_row *row, const sure_ray *ray, const void *shape,
                  const filter_end *end, double *t)
{
    if (!environment_is_nearest())
        return false;
    if (end->end.at == END_TANGENT)
        return tangent_polish(row, ray, shape, end->t, t);
    return polish(close_of(row)->step, row->steps, ray, shape, end, t);
}

filter_verdict close_hit(const shape_row *row, const sure_ray *ray, const void *shape,
                         t_wanted wanted, sure_hit *hit)
{
    const close_row *close = close_of(row);
    if (close->refine_hit == NULL || !environment_is_nearest())
        return FILTER_UNCERTAIN;
    return close->refine_hit(ray, shape, wanted, hit);
}

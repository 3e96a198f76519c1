/* SPDX-License-Identifier: MIT */
#include "normal.h"

#include "../../numbers/environment.h"
#include "beyond.h"
#include "../query.h"

#include <assert.h>

static NOT_INLINED bool normal_nearly(const shape_row *row, const sure_ray *ray, const void *shape,
                                      const sure_hit *hit, t_wanted wanted, sure_vec3 *normal)
{
    query q;
    sure_hit scaled = *hit;
    if (interaction_normal(row, ray, shape, hit, wanted == T_EXACT, normal))
        return true;
    return query_of(ray, row, shape, &q) && q.shape != shape &&
           query_shift(hit->t, -q.t_exponent, &scaled.t) &&
           query_shift(hit->t_error, -q.t_exponent, &scaled.t_error) &&
           interaction_normal(row, q.ray, q.shape, &scaled, wanted == T_EXACT, normal);
}

sure_vec3 stages_normal(const shape_row *row, const sure_ray *ray, const void *shape,
                        const sure_hit *hit, t_wanted wanted)
{
    assert(shape_check(row, ray, shape) == SURE_FIELD_NONE && hit_in_range(ray, hit));
    bool answered;
    sure_vec3 normal;
    TO_NEAREST(answered, normal_nearly(row, ray, shape, hit, wanted, &normal));
    return answered ? normal : rounded_normal(ray, row, shape);
}

/* SPDX-License-Identifier: MIT */
#include "../stages.h"
#include "line.h"

/* Its room is a few KB of the stack. */
NOT_INLINED sure_status stages_last_hit(const shape_row *row, const sure_ray *ray,
                                        const void *shape, t_wanted wanted, sure_hit *hit)
{
    exact_arena room;
    exact_context c = exact_start(&room);
    line_coefficients l;
    tagged_end first;
    bool leaves;
    sure_status status = line_hit(&c, ray, row, shape, &l, &first, &leaves);
    if (status != SURE_HIT || wanted == T_NONE) /* t's rounding takes longer than all else */
        return status;
    double t = round_t(&c, ray, &l, first.at);
    bool known = first.at == END_START ||
                 (wanted == T_CERTAIN && is_finite_bits(t) &&
                  line_compare(&c, &l, first.at, exact_of(&c, t), exact_of(&c, 1)) == 0);
    *hit = (sure_hit){t, known ? 0 : half_ulp(t), first.part, leaves};
    return status;
}

NOT_INLINED sure_status stages_last_interval(const shape_row *row, const sure_ray *ray,
                                             const void *shape, sure_interval *interval)
{
    exact_arena room;
    exact_context c = exact_start(&room);
    line_coefficients l;
    tagged_interval ends;
    sure_status status = line_interval(&c, ray, row, shape, &l, &ends);
    if (status != SURE_HIT)
        return status;
    bool endless = ends.enter.at == END_ENDLESS;
    *interval = (sure_interval){endless ? -INFINITY : round_t(&c, ray, &l, ends.enter.at),
                                endless ? INFINITY : round_t(&c, ray, &l, ends.leave.at),
                                ends.enter.part, ends.leave.part};
    return status;
}

/* The stages between the filter and the exact one: double-double, then with residues. */
#ifndef STAGES_WIDE_STAGES_H
#define STAGES_WIDE_STAGES_H

#include "../numbers/near.h"
#include "ladder.h"
#include "question.h"

/* The double nearest to a number known nearly, when its error leaves no other; not for numbers near
 * the ends of the range. */
static inline bool wide_rounds_to(near x, double *rounded)
{
    double slack = x.error * (1 + 0x1p-40) + fabs(x.lo) * 0x1p-50;
    *rounded = x.hi;
    return fabs(x.hi) > 0x1p-900 && x.hi + (x.lo + slack) == x.hi && x.hi + (x.lo - slack) == x.hi;
}

/* True when one of them answered: the status, *stage, and *hit or *interval as wanted. The first to
 * try is *stage. Entry: round to nearest; valid input. */
bool wide_hit(const question *asked, t_wanted wanted, sure_status *status, sure_hit *hit,
              sure_stage *stage);
bool wide_interval(const question *asked, t_wanted wanted, sure_status *status,
                   sure_interval *interval);

/* Each component within SURE_NORMAL_ERROR, or rounded correctly. Entry: the part that is hit. */
bool wide_normal(const question *asked, sure_part part, t_wanted wanted, sure_vec3 *normal);

/* The hit point o + t d, correctly rounded. */
bool wide_point(const question *asked, sure_vec3 *hit_point);

#endif

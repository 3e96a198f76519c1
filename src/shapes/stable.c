/* SPDX-License-Identifier: MIT */
#include "stable.h"

#include "../stages/query.h"

/* x 2^exponent; what is not 0 does not become so, and stays on its side of the range. */
static double scaled_back(double x, int exponent)
{
    double scaled = ldexp(x, exponent);
    return scaled == 0 && x != 0 ? copysign(0x1p-1074, x) : scaled;
}

/* Scaled where numbers are very large or small: few products of the guess then over- or
 * underflow. */
static span guess_of(stable_guess *guess, const query *q)
{
    span found = guess(q->ray, q->shape);
    if (!(found.enter <= found.leave)) /* or both might overflow alike */
        return span_empty();
    found.enter = scaled_back(found.enter, q->t_exponent);
    found.leave = scaled_back(found.leave, q->t_exponent);
    return found;
}

/* The first stage once more, of the scaled ray. */
static filter_verdict hit_scaled(const shape_row *row, const query *q, sure_hit *hit)
{
    filter_interval found;
    filter_end first;
    filter_verdict verdict = stages_first(row->filter, q->ray, q->shape, &found, &first);
    if (verdict != FILTER_INTERVAL)
        return verdict;
    sure_hit scaled = filter_hit(&found, &first);
    if (!(query_unscale(q, first.t, &scaled.t) && query_unscale(q, first.error, &scaled.t_error)))
        return FILTER_UNCERTAIN;
    *hit = scaled;
    return FILTER_INTERVAL;
}

sure_status stable_rest_of_hit(const shape_row *row, stable_guess *guess, const sure_ray *ray,
                               const void *shape, sure_hit *hit)
{
    query q;
    if (shape_check(row, ray, shape) != SURE_FIELD_NONE)
        return SURE_INVALID;
    (void)query_of(ray, row, shape, &q);
    filter_verdict verdict = hit_scaled(row, &q, hit);
    if (verdict != FILTER_UNCERTAIN)
        return verdict == FILTER_MISS ? SURE_MISS : SURE_HIT;
    span found = guess_of(guess, &q);
    return span_hit(&found, ray, hit);
}

sure_status stable_interval(const shape_row *row, stable_guess *guess, const sure_ray *ray,
                            const void *shape, sure_interval *interval)
{
    query q;
    filter_interval known;
    filter_verdict verdict = row->filter(ray, shape, &known);
    if (verdict == FILTER_INTERVAL)
        verdict = filter_meets(&known, ray);
    if (verdict == FILTER_MISS)
        return SURE_MISS;
    if (verdict == FILTER_INTERVAL) {
        *interval = (sure_interval){known.enter.t, known.leave.t, known.enter.end.part,
                                    known.leave.end.part};
        stages_order_ends(interval);
        return SURE_HIT;
    }
    if (shape_check(row, ray, shape) != SURE_FIELD_NONE)
        return SURE_INVALID;
    (void)query_of(ray, row, shape, &q);
    span found = guess_of(guess, &q);
    return span_interval(&found, ray, interval);
}

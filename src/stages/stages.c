/* SPDX-License-Identifier: MIT */
#include "stages.h"

#include "query.h"

/* What is asked for, and what is answered by which stage. On anything but a hit neither hit nor
 * interval is set. */
typedef struct {
    t_wanted wanted;
    bool both_ends;
    sure_status status;
    sure_stage stage;
    sure_hit hit;
    sure_interval interval;
} staged;

/* A certain end as one of the asked ray, and rounded correctly if wanted; false where that can't be
 * told. */
static bool end_as_wanted(const shape_row *row, const query *q, t_wanted wanted, filter_end *end)
{
    double t = end->t;
    const bool told = is_zero_bits(end->error);
    if (filter_at_start(end))
        return true;
    if (wanted == T_EXACT && !told && !close_polish(row, q->ray, q->shape, end, &t))
        return false;
    return query_unscale(q, t, &end->t) && (told || query_unscale(q, end->error, &end->error));
}

/* t where the range is, in which t* is. By bits: t_min may be subnormal. */
static double in_range(double t, const sure_ray *asked)
{
    if (is_negative_bits(t) || bits_of(t) < bits_of(asked->t_min))
        return asked->t_min;
    return bits_of(t) > bits_of(asked->t_max) ? asked->t_max : t;
}

static bool take_first(const shape_row *row, const query *q, const filter_interval *found,
                       staged *answer)
{
    filter_end first;
    filter_interval ends = *found;
    filter_verdict verdict = filter_first_known(found, q->ray, &first);
    /* An end that is next to a bound as doubles have it is known better first. */
    if (verdict == FILTER_UNCERTAIN && answer->stage != SURE_STAGE_DOUBLE)
        verdict = query_first(row, q, &ends, &first, &answer->stage);
    if (verdict != FILTER_INTERVAL)
        return verdict == FILTER_MISS;
    answer->status = SURE_HIT;
    answer->hit = filter_hit(&ends, &first);
    if (!end_as_wanted(row, q, answer->wanted, &first))
        return false;
    bool rounded = answer->wanted == T_EXACT && first.end.at != END_START;
    answer->hit.t = in_range(first.t, q->asked);
    answer->hit.t_error = rounded ? half_ulp(first.t) : first.error;
    return true;
}

static bool take_both(const shape_row *row, const query *q, const filter_interval *found,
                      staged *answer)
{
    filter_end enter = found->enter, leave = found->leave;
    filter_verdict verdict = filter_meets(found, q->ray);
    if (verdict != FILTER_INTERVAL)
        return verdict == FILTER_MISS;
    answer->status = SURE_HIT;
    if (!end_as_wanted(row, q, answer->wanted, &enter) ||
        !end_as_wanted(row, q, answer->wanted, &leave))
        return false;
    answer->interval = (sure_interval){enter.t, leave.t, enter.end.part, leave.end.part};
    stages_order_ends(&answer->interval);
    return true;
}

/* What a stage found for the query, as an answer; false when it is none. */
static bool take(const shape_row *row, const query *q, filter_verdict verdict,
                 const filter_interval *found, staged *answer)
{
    answer->status = SURE_MISS;
    if (verdict != FILTER_INTERVAL)
        return verdict == FILTER_MISS;
    return answer->both_ends ? take_both(row, q, found, answer) : take_first(row, q, found, answer);
}

static bool refined(const shape_row *row, const query *q, staged *answer)
{
    filter_interval found;
    if (row->refine == NULL)
        return false;
    filter_verdict verdict =
        row->refine(q->ray, q->shape, answer->both_ends, &found, &answer->stage);
    return take(row, q, verdict, &found, answer);
}

static bool filtered(const shape_row *row, const query *q, staged *answer)
{
    filter_interval found;
    answer->stage = SURE_STAGE_DOUBLE;
    filter_verdict verdict = row->filter(q->ray, q->shape, &found);
    if (!take(row, q, verdict, &found, answer))
        return false;
    if (answer->status == SURE_HIT && answer->wanted == T_EXACT)
        answer->stage = SURE_STAGE_DOUBLE_DOUBLE;
    return true;
}

/* A hit of the query as one of the asked ray; false where it might be rounded. */
static bool unscaled_hit(const query *q, t_wanted wanted, sure_hit *hit)
{
    double t = hit->t;
    if (q->ray == q->asked)
        return true;
    if (bits_of(t) == bits_of(q->ray->t_min) && is_zero_bits(hit->t_error))
        hit->t = q->asked->t_min;
    else if (!is_zero_bits(t) && !query_unscale(q, t, &hit->t))
        return false;
    if (wanted == T_EXACT && !is_zero_bits(hit->t_error))
        hit->t_error = half_ulp(hit->t);
    return is_zero_bits(hit->t_error) || wanted == T_EXACT ||
           query_unscale(q, hit->t_error, &hit->t_error);
}

/* The second stage of planar shapes. */
static bool refined_hit(const shape_row *row, const query *q, staged *answer)
{
    sure_hit found;
    if (answer->both_ends)
        return false;
    answer->stage = SURE_STAGE_DOUBLE_DOUBLE;
    answer->status = SURE_MISS;
    filter_verdict verdict = close_hit(row, q->ray, q->shape, answer->wanted, &found);
    if (verdict != FILTER_INTERVAL)
        return verdict == FILTER_MISS;
    answer->status = SURE_HIT;
    answer->hit = found;
    return unscaled_hit(q, answer->wanted, &answer->hit);
}

/* 2. Better coefficients: double-doubles, then integers modulo 2^128.
 * 3. Both stages again for a query that is scaled into their range.
 * 4. Exact integers. */
static void answer_rest(const shape_row *row, const sure_ray *ray, const void *shape,
                        staged *answer)
{
    query q;
    query_unscaled(ray, shape, &q);
    if (refined_hit(row, &q, answer) || refined(row, &q, answer))
        return;
    if (shape_check(row, ray, shape) != SURE_FIELD_NONE) {
        answer->stage = SURE_STAGE_DOUBLE;
        answer->status = SURE_INVALID;
        return;
    }
    if (query_of(ray, row, shape, &q) && q.shape != shape &&
        (filtered(row, &q, answer) || refined_hit(row, &q, answer) || refined(row, &q, answer)))
        return;
    answer->stage = SURE_STAGE_EXACT;
    answer->status = answer->both_ends
                         ? stages_last_interval(row, ray, shape, &answer->interval)
                         : stages_last_hit(row, ray, shape, answer->wanted, &answer->hit);
}

NOT_INLINED sure_status stages_rest_of_hit(const sure_ray *ray, const void *shape, sure_hit *hit,
                                           const shape_row *row, t_wanted wanted, sure_stage *stage)
{
    staged answer = {.wanted = wanted, .both_ends = false};
    answer_rest(row, ray, shape, &answer);
    if (answer.status == SURE_HIT)
        *hit = answer.hit;
    *stage = answer.stage;
    return answer.status;
}

NOT_INLINED sure_status stages_rest_of_interval(const sure_ray *ray, const void *shape,
                                                sure_interval *interval, const shape_row *row,
                                                t_wanted wanted)
{
    staged answer = {.wanted = wanted, .both_ends = true};
    answer_rest(row, ray, shape, &answer);
    if (answer.status == SURE_HIT)
        *interval = answer.interval;
    return answer.status;
}

NOT_INLINED sure_status stages_occluded(const sure_ray *ray, const void *shape,
                                        const shape_row *row)
{
    filter_interval found;
    filter_end first;
    sure_hit unused;
    sure_stage stage;
    filter_verdict verdict = stages_first(row->filter, ray, shape, &found, &first);
    if (verdict != FILTER_UNCERTAIN)
        return verdict == FILTER_MISS ? SURE_MISS : SURE_HIT;
    return stages_rest_of_hit(ray, shape, &unused, row, T_NONE, &stage);
}

NOT_INLINED sure_status stages_certain_rest(const sure_ray *ray, const void *shape, sure_hit *hit,
                                            const shape_row *row)
{
    sure_stage unused;
    return stages_rest_of_hit(ray, shape, hit, row, T_CERTAIN, &unused);
}

NOT_INLINED sure_status stages_certain_hit(const sure_ray *ray, const void *shape, sure_hit *hit,
                                           const shape_row *row)
{
    sure_stage unused;
    return stages_hit(row, ray, shape, T_CERTAIN, hit, &unused);
}

/* SPDX-License-Identifier: MIT */
#include "crowd.h"

#include "../../cases/moved.h"
#include "../../numbers/sums.h"

#include <math.h>

sure_case case_of(const walker *w, int solid, sure_vec3 direction)
{
    sure_case question = {.ray = w->ray, .object = w->in.solids[solid]};
    question.ray.direction = direction;
    return question;
}

bool ask_truth(crowd *all)
{
    int count = 0;
    for (walker *w = all->walkers; w < all->walkers + CROWD; w++) {
        for (int i = 0; i < w->in.count; i++, count++) {
            all->ahead[count] = case_of(w, i, w->ray.direction);
            all->behind[count] = case_of(w, i, negate(w->ray.direction));
        }
    }
    if (!truth_ask(all->known, QUERY_HIT, all->ahead, NULL, count, all->answers, all->message) ||
        !truth_statuses(all->known, all->behind, count, all->statuses, all->message))
        return false;
    count = 0;
    for (walker *w = all->walkers; w < all->walkers + CROWD; w++) {
        for (int i = 0; i < w->in.count; i++, count++) {
            w->ahead[i] = all->answers[count];
            w->behind[i] = all->statuses[count];
        }
    }
    return true;
}

static void ask_tier(crowd *all)
{
    for (walker *w = all->walkers; w < all->walkers + CROWD; w++) {
        w->is_asked = true;
        for (int i = 0; i < w->in.count; i++)
            w->answered[i] = sure_object_hit(&w->ray, &w->in.solids[i], all->by->tier, &w->hits[i]);
    }
}

/* As the candidate receives it, in the same unit of length; false: it can't be asked. */
static bool take_question(const candidate *by, const walker *w, int solid, sure_case *to)
{
    const sure_case question = case_of(w, solid, w->ray.direction);
    precision in = by->answers_in[QUERY_HIT][question.object.shape];
    return entry_case(&by->entry, &question, in, to) &&
           fabs(object_size(&to->object) / object_size(&question.object) - 1) < 0x1p-20;
}

static void ask_candidate(crowd *all)
{
    static block asked;
    asked.shape = all->shape;
    asked.count = 0;
    for (walker *w = all->walkers; w < all->walkers + CROWD; w++) {
        int first = asked.count;
        for (int i = 0; i < w->in.count; i++)
            asked.count += take_question(all->by->asked, w, i, &asked.cases[asked.count]);
        w->is_asked = asked.count == first + w->in.count;
        asked.count = w->is_asked ? asked.count : first;
    }
    candidate_ask(all->by->asked, &asked);
    const reply *given = asked.replies;
    for (walker *w = all->walkers; w < all->walkers + CROWD; w++) {
        bool is_answered = w->is_asked;
        for (int i = 0; i < w->in.count && w->is_asked; i++, given++) {
            is_answered &= given->kind != REPLY_UNASKED; /* it is given up on */
            w->answered[i] = given->kind == REPLY_ANSWERED ? given->status : SURE_INVALID;
            w->hits[i].t = given->t;
        }
        w->is_asked = is_answered;
    }
}

void ask_routine(crowd *all)
{
    if (all->by->asked)
        ask_candidate(all);
    else
        ask_tier(all);
}

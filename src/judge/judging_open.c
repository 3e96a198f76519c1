/* SPDX-License-Identifier: MIT */
/* A judgement of who answers in a process of its own, or has written its answers before; times. */
#include "judging_state.h"

#include <string.h>

#define TIER_TIME_LIMIT 60 /* seconds for a tier's answer, which always comes */

/* Nanoseconds for the hits of all these cases, and for their normals where the candidate gives
 * them: the faster of two passes, in an order that nobody has been asked in. 0: not known. */
static double time_of(judging *self, sure_tier tier, candidate_inputs inputs, const block *asked)
{
    const candidate_options how = {.inputs = inputs, .time_limit = TIER_TIME_LIMIT};
    candidate **of = &self->tiers[tier][asked->with_normals][inputs == INPUTS_FLOAT];
    block *room = &self->room;
    if (!*of && !(*of = candidate_of_tier(tier, asked->with_normals, &how, NULL)))
        return 0;
    room->shape = asked->shape;
    room->asks = asked->asks;
    room->for_time = true;
    room->count = asked->count;
    memcpy(room->cases, asked->cases, (size_t)room->count * sizeof *room->cases);
    shuffle_cases(room->cases, room->count, &self->order);
    candidate_ask(*of, room);
    return room->nanoseconds;
}

/* A tier's own time is taken as those beside it. */
static void take_times(judging *self, ledger *of)
{
    const block *asked = &of->asked;
    double own = self->asked->is_tier
                     ? time_of(self, self->plan->tier, self->plan->how.inputs, asked)
                     : asked->nanoseconds;
    if (own == 0)
        return;
    of->times.candidate += own;
    of->times.building += asked->building;
    of->times.textbook += time_of(self, SURE_TIER_TEXTBOOK, INPUTS_DOUBLE, asked);
    of->times.certain += time_of(self, SURE_TIER_CERTAIN, INPUTS_DOUBLE, asked);
    of->rays += (uint64_t)asked->count;
}

static candidate *open_candidate(judging *self, char *message)
{
    const judging_plan *plan = self->plan;
    switch (plan->subject) {
    case SUBJECT_TIER: return candidate_of_tier(plan->tier, true, &plan->how, message);
    case SUBJECT_LIBRARY: return candidate_of_library(plan->name, &plan->how, message);
    case SUBJECT_COMMAND:
        return plan->how.keep ? candidate_of_kept(plan->name, &plan->how, message)
                              : candidate_of_command(plan->name, &plan->how, message);
    default: break;
    }
    self->absent = candidate_by_lines(&plan->how);
    self->answers = judging_input(plan->name, message);
    self->read_answer = judging_read_answer;
    return self->answers ? &self->absent : NULL;
}

judging *judging_open(const judging_plan *plan, char *message)
{
    judging *self = judging_of(plan, NULL, message);
    if (!self)
        return NULL;
    self->take_times = plan->untimed ? NULL : take_times;
    self->asked = open_candidate(self, message);
    if (self->asked &&
        (!plan->by_reference || truth_reference(plan->how.time_limit, &self->known, message)))
        return self;
    judging_close(self);
    return NULL;
}

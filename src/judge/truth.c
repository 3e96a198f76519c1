/* SPDX-License-Identifier: MIT */
#include "truth.h"

#include <string.h>

static bool is_whole(const reply *given, bool wall)
{
    bool told =
        wall || given->to == QUERY_INTERVAL || (given->part != REPLY_NO_PART && given->has_normal);
    if (given->kind != REPLY_ANSWERED)
        return false;
    return given->status == SURE_HIT       ? told
           : given->status == SURE_INVALID ? given->field != SURE_FIELD_NONE
                                           : true;
}

static bool take(const sure_case *question, const reply *given, case_answer *answer, char *message)
{
    char line[CASE_LINE_MAX], said[CASE_LINE_MAX];
    if (!is_whole(given, question->wall)) {
        case_print(question, line);
        reply_print(given, said);
        return complain(message, "the truth has no answer (%.80s) to: %.400s", said, line);
    }
    *answer = (case_answer){.status = given->status,
                            .field = given->field,
                            .t = given->t,
                            .t_leave = given->t_leave,
                            .part = given->part != REPLY_NO_PART ? (sure_part)given->part : 0,
                            .normal = given->normal};
    return true;
}

/* Where it knows first hits that is what is asked, else both ends of the chord. */
static bool by_hit(query asks)
{
    return asks == QUERY_HIT || asks == QUERY_OCCLUDED;
}

static void ask_program(truth *known, query asks, const sure_case *cases, int count)
{
    const truth_kind of_hits = cases[0].wall ? TRUTH_WALLS : TRUTH_HITS;
    known->room.asks = by_hit(asks) ? QUERY_HIT : QUERY_INTERVAL;
    known->room.shape = cases[0].object.shape;
    known->room.count = count;
    memcpy(known->room.cases, cases, (size_t)count * sizeof *cases);
    candidate_ask(known->programs[by_hit(asks) ? of_hits : TRUTH_INTERVALS], &known->room);
}

static case_answer exact_chord(const sure_case *question)
{
    const sure_ray *ray = &question->ray;
    sure_interval chord = {0};
    sure_status status = sure_object_interval(ray, &question->object, SURE_TIER_EXACT, &chord);
    return (case_answer){.status = status,
                         .field = sure_object_check(ray, &question->object),
                         .t = chord.t_enter,
                         .t_leave = chord.t_leave};
}

bool truth_ask(truth *known, query asks, const sure_case *cases, const reply *replies, int count,
               case_answer *answers, char *message)
{
    if (known->programs[0])
        ask_program(known, asks, cases, count);
    for (int i = 0; i < count; i++) {
        bool with_normal = !replies || replies[i].has_normal;
        if (known->programs[0] && !take(&cases[i], &known->room.replies[i], &answers[i], message))
            return false;
        if (!known->programs[0])
            answers[i] = by_hit(asks) ? case_hit_of(&cases[i], SURE_TIER_EXACT, with_normal)
                                      : exact_chord(&cases[i]);
    }
    return true;
}

void truth_complete(const truth *known, example *one)
{
    if (!known->programs[0] && one->found && by_hit(one->given.to))
        one->truth = case_answer_of(&one->question, SURE_TIER_EXACT);
}

bool truth_statuses(truth *known, const sure_case *cases, int count, sure_status *statuses,
                    char *message)
{
    case_answer answer = {.status = SURE_INVALID};
    if (!known->programs[0]) {
        for (int i = 0; i < count; i++)
            statuses[i] = cases[i].wall ? case_answer_of(&cases[i], SURE_TIER_EXACT).status
                                        : sure_object_occluded(&cases[i].ray, &cases[i].object,
                                                               SURE_TIER_EXACT);
        return true;
    }
    ask_program(known, QUERY_OCCLUDED, cases, count);
    for (int i = 0; i < count; i++) {
        if (!take(&cases[i], &known->room.replies[i], &answer, message))
            return false;
        statuses[i] = answer.status;
    }
    return true;
}

void truth_close(truth *known)
{
    for (int i = 0; i < TRUTH_KINDS; i++) {
        candidate_close(known->programs[i]);
        known->programs[i] = NULL;
    }
}

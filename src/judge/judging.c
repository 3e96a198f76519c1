/* SPDX-License-Identifier: MIT */
#include "judging_state.h"

#include <stdlib.h>

/* The tiers are asked one in so many blocks too, for their times, until these have taken so many
 * nanoseconds. */
#define TIMED_OF 8
/* Cases that are timed stay in the cache; of others many are asked at once. */
#define TIMED_BLOCK 1024
#define TIMED_MOST 1e8

const char *judging_row_name(int which)
{
    return which == JUDGING_GIVEN ? "given" : regime_name((regime)which);
}

const char *judging_topic(query asks, sure_shape shape, judging_words words)
{
    bool hit = asks == QUERY_HIT;
    snprintf(words, sizeof(judging_words), "%s%s%s", sure_shape_name(shape), hit ? "" : " ",
             hit ? "" : query_names[asks]);
    return words;
}

judging *judging_of(const judging_plan *plan, candidate *asked, char *message)
{
    judging *self = calloc(1, sizeof *self);
    if (!self) {
        candidate_close(asked);
        complain(message, "no memory");
        return NULL;
    }
    self->plan = plan;
    self->asked = asked;
    return self;
}

void judging_close(judging *self)
{
    if (!self)
        return;
    for (int i = 0; i < SURE_TIERS * 4; i++)
        candidate_close(self->tiers[i / 4][i / 2 % 2][i % 2]);
    candidate_close(self->asked);
    truth_close(&self->known);
    if (self->answers)
        fclose(self->answers);
    for (int i = 0; i < QUERIES * SURE_SHAPES * JUDGING_ROWS; i++)
        free((&self->ledgers[0][0][0])[i]);
    free(self);
}

const candidate *judging_asked(const judging *self)
{
    return self->asked;
}

identity judging_who(const judging *self)
{
    identity who = self->asked->is_tier ? self->plan->surehit : self->asked->who;
    if (self->plan->subject == SUBJECT_COMMAND && who.name[0] == '\0')
        snprintf(who.name, sizeof who.name, "%s", self->plan->name);
    return who;
}

bool judging_is_quick(const judging *self)
{
    return self->asked->is_quick && !self->known.programs[0];
}

ledger *ledger_of(judging *self, query asks, sure_shape shape, int which, char *message)
{
    ledger **of = &self->ledgers[asks][shape][which];
    if (*of)
        return *of;
    *of = calloc(1, sizeof **of);
    if (!*of) {
        complain(message, "no memory");
        return NULL;
    }
    (*of)->counted.answers_in = self->asked->answers_in[asks][shape];
    (*of)->which = which;
    (*of)->entry = entry_for(&self->asked->entry, asks);
    (*of)->asked.asks = asks;
    (*of)->asked.shape = shape;
    return *of;
}

static bool is_for_time(const judging *self, const ledger *of)
{
    bool turn = of->blocks % TIMED_OF == 0 || self->asked->is_program;
    return turn && of->times.textbook + of->times.certain <= TIMED_MOST;
}

/* Cases. */

/* Asks the cases that have come together, and counts. */
static bool judge_block(judging *self, ledger *of, char *message)
{
    block *asked = &of->asked;
    if (asked->count == 0)
        return true;
    if (self->last != of)
        candidate_forgive(self->asked);
    self->last = of;
    if (!self->answers) {
        asked->for_time = self->take_times && is_for_time(self, of);
        candidate_ask(self->asked, asked);
        if (asked->for_time)
            self->take_times(self, of);
    }
    if (!truth_ask(&self->known, asked->asks, asked->cases, asked->replies, asked->count,
                   self->right, message))
        return false;
    for (int i = 0; i < asked->count; i++) {
        example one = {true, asked->cases[i], asked->replies[i], self->right[i], of->numbers[i]};
        referee_take_t(&of->entry, &one);
        unsigned faults =
            referee(&of->looked_at, &self->plan->told, &of->entry, of->counted.answers_in, &one);
        tally_add(&of->counted, &one, faults, of->has_lengths ? &of->lengths[i] : NULL);
    }
    of->blocks++;
    asked->count = 0;
    return true;
}

bool ledger_add(judging *self, ledger *of, const sure_case *question, char *message)
{
    block *asked = &of->asked;
    sure_case *place = &asked->cases[asked->count];
    bool possible = entry_query(&of->entry, asked->asks, question, of->counted.answers_in, place);
    if (self->answers && !self->read_answer(self, &asked->replies[asked->count], message))
        return false;
    if (!possible) {
        of->counted.sum.skipped++;
        return true;
    }
    of->numbers[asked->count++] = of->number;
    const int most = self->asked->block_cases;
    const int cases = self->take_times && most > TIMED_BLOCK ? TIMED_BLOCK : most;
    return asked->count < cases || judge_block(self, of, message);
}

/* The cases that are told have whole answers. */
static void complete(const truth *known, ledger *of)
{
    verdict *sum = &of->counted.sum;
    truth_complete(known, &sum->worst_t);
    for (int i = 0; i < FAULTS; i++)
        truth_complete(known, &sum->faulty[i]);
    for (int i = 0; i < FAULTS_WITH_MARGIN; i++)
        truth_complete(known, &of->looked_at.widest[i]);
}

bool ledger_finish(judging *self, ledger *of, judging_row *row, char *message)
{
    const judging_times *sum = &of->times;
    if (!judge_block(self, of, message))
        return false;
    complete(&self->known, of);
    double rays = of->rays > 0 ? (double)of->rays : 1;
    *row = (judging_row){.asks = of->asked.asks,
                         .shape = of->asked.shape,
                         .which = of->which,
                         .sum = tally_verdict(&of->counted),
                         .looked_at = of->looked_at,
                         .times = {sum->candidate / rays, sum->textbook / rays, sum->certain / rays,
                                   sum->building / rays}};
    self->last = NULL;
    self->ledgers[row->asks][row->shape][row->which] = NULL;
    free(of);
    return true;
}

/* The next one of the block. */
static sure_case make_case(const judging *self, ledger *of, uint64_t index)
{
    sure_shape shape = of->asked.shape;
    if (of->which != REGIME_CAMERA)
        return regime_case(shape, (regime)of->which, self->plan->seed, index);
    rng g = regime_rng(shape, REGIME_CAMERA, self->plan->seed, index);
    camera_case made = camera_case_of(shape, &g);
    of->has_lengths = true;
    of->lengths[of->asked.count] = camera_lengths_of(&made);
    return made.question;
}

bool ledger_judge(judging *self, ledger *of, uint64_t first, uint64_t end, char *message)
{
    uint64_t shown = first;
    for (of->number = first; of->number < end; of->number++) {
        sure_case question = make_case(self, of, of->number);
        if (!ledger_add(self, of, &question, message))
            return false;
        if (of->asked.count > 0)
            continue;
        progress_step(self->bar, (int64_t)(of->number + 1 - shown)); /* a block was judged */
        shown = of->number + 1;
    }
    progress_step(self->bar, (int64_t)(end - shown));
    return judge_block(self, of, message);
}

bool judging_regime(judging *self, query asks, sure_shape shape, regime which, uint64_t count,
                    judging_row *row, char *message)
{
    ledger *of = ledger_of(self, asks, shape, (int)which, message);
    return of && ledger_judge(self, of, 0, count, message) && ledger_finish(self, of, row, message);
}

/* Can the candidate be asked just this? */
static bool is_possible(const judging *self, query asks, const sure_case *question)
{
    const entry of = entry_for(&self->asked->entry, asks);
    return entry_is_query(asks, question) &&
           entry_holds(&of, question, self->asked->answers_in[asks][question->object.shape]);
}

margin_unit judging_unit(const judging *self)
{
    return self->plan->told.unit;
}

unsigned judging_faults(const judging *self, const example *one)
{
    const entry of = entry_for(&self->asked->entry, one->given.to);
    return faults_by_entry(&of, one);
}

bool judging_asks(const judging *self, query asks, sure_shape shape)
{
    const judging_plan *plan = self->plan;
    bool wanted = plan->some_queries ? plan->queries[asks]
                                     : asks == QUERY_HIT || plan->subject == SUBJECT_LIBRARY;
    return wanted && self->asked->answers[asks][shape];
}

bool judging_several(judging *self, query asks, const sure_case *questions, int count,
                     example *answered)
{
    block *asked = &self->room;
    if (self->answers)
        return false;
    asked->shape = questions[0].object.shape;
    asked->asks = asks;
    asked->count = 0;
    asked->for_time = false;
    for (int i = 0; i < count; i++) {
        answered[i] =
            (example){.found = is_possible(self, asks, &questions[i]), .question = questions[i]};
        if (answered[i].found)
            asked->cases[asked->count++] = questions[i];
    }
    if (asked->count == 0)
        return true;
    candidate_forgive(self->asked);
    candidate_ask(self->asked, asked);
    if (!truth_ask(&self->known, asks, asked->cases, NULL, asked->count, self->right, NULL))
        return false;
    for (int i = 0, n = 0; i < count; i++) {
        if (!answered[i].found)
            continue;
        answered[i].given = asked->replies[n];
        answered[i].truth = self->right[n++];
    }
    return true;
}

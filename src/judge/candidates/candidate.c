/* SPDX-License-Identifier: MIT */
#include "candidate.h"

#include "../../support/printable.h"
#include "../../support/progress.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

/* So many in a row of cases are borne in any case; each hang costs the time limit. */
#define BORNE_CRASHES 16
#define MOST_HANGS 2

#define FEWER 16 /* times: who is slow is asked so many fewer at once */

/* Seconds to start in, at least. */
#define START_LIMIT 5

bool complain(char *message, const char *format, ...)
{
    char text[CANDIDATE_MESSAGE];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    if (message)
        printable_write(message, CANDIDATE_MESSAGE, text);
    return false;
}

double candidate_start_limit(const candidate *self)
{
    return fmax(self->time_limit, START_LIMIT);
}

candidate candidate_by_lines(const candidate_options *how)
{
    candidate made = {
        .block_cases = BLOCK_CASES, .is_program = true, .time_limit = how->time_limit};
    if (how->entry)
        (void)entry_read(how->entry, &made.entry); /* it was read before */
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        made.answers[QUERY_HIT][shape] = true;
        made.answers_in[QUERY_HIT][shape] =
            how->inputs == INPUTS_FLOAT || made.entry.in_float ? PRECISION_FLOAT : PRECISION_DOUBLE;
    }
    return made;
}

static void blame(candidate *self, block *asked, int at, const candidate_end *end)
{
    reply_fill(asked->replies, at, 1, end->kind, end->ended);
    if (end->kind == REPLY_HUNG)
        self->ends.hangs++;
    else
        self->ends.crashes++;
}

static int ends_of(const candidate *self)
{
    return self->ends.crashes + self->ends.hangs;
}

static bool is_given_up(const candidate *self)
{
    const candidate_ends *ends = &self->ends;
    double cost = ends->cost + (ends->since > 0 ? progress_clock() - ends->since : 0);
    return ends->hangs >= MOST_HANGS ||
           (ends->crashes >= BORNE_CRASHES &&
            (ends->crashes > ends->answered || cost > self->time_limit));
}

void candidate_is_slow(candidate *self, block *asked, int count)
{
    self->block_cases = count > FEWER ? count / FEWER : 1;
    asked->nanoseconds = -INFINITY; /* not known */
}

static void ask_part(candidate *self, block *asked, int first, int count);

/* The cases before the one that is to blame, that one unless it surely is, and the rest by halves;
 * all by halves where nobody seems to be. Should all do well now, it was slow, or all of them
 * together are to blame, and the first stands for it. */
static void ask_again(candidate *self, block *asked, int first, int count, const candidate_end *end)
{
    int ends = ends_of(self), at = end->blamed < 0 ? first - 1 : end->blamed;
    int rest = first + count - at - 1;
    if (end->surely) {
        blame(self, asked, at, end);
        ask_part(self, asked, first, at - first);
        ask_part(self, asked, at + 1, rest);
        return;
    }
    if (end->blamed >= 0) {
        ask_part(self, asked, first, at - first);
        ask_part(self, asked, at, 1);
    }
    ask_part(self, asked, at + 1, rest / 2);
    ask_part(self, asked, at + 1 + rest / 2, rest - rest / 2);
    if (ends_of(self) == ends && end->kind == REPLY_HUNG)
        candidate_is_slow(self, asked, count);
    else if (ends_of(self) == ends)
        blame(self, asked, first, end);
}

static void ask_part(candidate *self, block *asked, int first, int count)
{
    for (int most; count > (most = self->block_cases); first += most, count -= most)
        ask_part(self, asked, first, most);
    if (count == 0)
        return;
    if (is_given_up(self)) {
        reply_fill(asked->replies, first, count, REPLY_UNASKED, 0);
        return;
    }
    double begun = progress_clock();
    candidate_end end = self->ask(self, asked, first, count);
    if (end.kind == REPLY_ANSWERED)
        self->ends.answered += count;
    else if (self->ends.since == 0)
        self->ends.since = begun;
    if (end.kind != REPLY_ANSWERED && count == 1)
        blame(self, asked, first, &end);
    else if (end.kind != REPLY_ANSWERED)
        ask_again(self, asked, first, count, &end);
}

void candidate_ask(candidate *self, block *asked)
{
    int ends = ends_of(self);
    asked->nanoseconds = asked->building = 0;
    for (int first = 0, most = self->block_cases; first < asked->count; first += most) {
        int left = asked->count - first;
        ask_part(self, asked, first, left < most ? left : most);
        if (self->ends.since > 0)
            self->ends.cost += progress_clock() - self->ends.since;
        self->ends.since = 0;
    }
    if (ends_of(self) > ends || asked->nanoseconds < 0)
        asked->nanoseconds = asked->building = 0;
    asked->with_normals = false;
    for (int i = 0; i < asked->count; i++) {
        asked->with_normals |= asked->replies[i].has_normal && !self->is_tier;
        asked->replies[i].to = candidate_tells(self, asked->asks);
    }
}

query candidate_tells(const candidate *self, query asked)
{
    return asked == QUERY_HIT && self->entry.decision ? QUERY_OCCLUDED : asked;
}

void candidate_forgive(candidate *self)
{
    self->ends = (candidate_ends){0};
}

void candidate_close(candidate *self)
{
    if (self && self->close)
        self->close(self);
}

/* SPDX-License-Identifier: MIT */
/* The judge for scripts: a function of theirs is asked, row by row. */
#include "export.h"
#include "facts.h"

#include "../judge/candidates/candidate_callback.h"
#include "../judge/conventions.h"
#include "../judge/findings/examples.h"

#include <stdio.h>
#include <string.h>

#define ROWS (SURE_SHAPES * REGIMES)

static judging *judge;
static judging_plan plan;
static char entry_words[CANDIDATE_MESSAGE], message[CANDIDATE_MESSAGE];
static judging_row rows[ROWS];
static worst_case worst[WORST_KINDS];
static int row_count;

/* The script's (candidate_callback.h). */
__attribute__((import_module("surehit"), import_name("ask"))) int
ask_script(const double *questions, double *answers);

static int answer(void *context, const double *questions, double *answers)
{
    (void)context;
    return ask_script(questions, answers);
}

/* A script does not end: it throws. */
void reply_print_end(int ended, char text[CASE_LINE_MAX])
{
    (void)ended;
    strcpy(text, "it threw an exception");
}

/* Entry conditions, to be written before judge_open. */
char *WASM_EXPORT(judge_entry)(void)
{
    return entry_words;
}

int WASM_EXPORT(judge_entry_size)(void)
{
    return sizeof entry_words;
}

/* A margin's unit in words, by number. */
const char *WASM_EXPORT(margin_word)(int unit)
{
    return margin_unit_names[unit];
}

void WASM_EXPORT(judge_close)(void)
{
    judging_close(judge);
    judge = NULL;
}

/* NULL, or what is wrong. */
const char *WASM_EXPORT(judge_open)(int in_float, int unit, double seed)
{
    entry wanted;
    entry_words[sizeof entry_words - 1] = '\0';
    const char *expected = entry_read(entry_words, &wanted);
    judge_close();
    row_count = 0;
    if (expected) {
        snprintf(message, sizeof message, "entry '%.200s': expected words %s", entry_words,
                 expected);
        return message;
    }
    plan = (judging_plan){.subject = SUBJECT_CALLBACK,
                          .how = {.inputs = in_float ? INPUTS_FLOAT : INPUTS_AS_IT_TAKES,
                                  .time_limit = 1e9, /* whoever started it can stop it */
                                  .entry = *entry_words ? entry_words : NULL},
                          .untimed = true,
                          .seed = (uint64_t)seed,
                          .told = margins_of((margin_unit)unit)};
    candidate *asked = candidate_of_callback(answer, NULL, &plan.how, message);
    judge = asked ? judging_of(&plan, asked, message) : NULL;
    return judge ? NULL : message;
}

static void tell_errors(const char *of, const error_summary *is)
{
    facts_member(of, "hits", (double)is->count);
    facts_member(of, "correctly_rounded", (double)is->right);
    facts_member(of, "median", is->median);
    facts_member(of, "99", is->q99);
    facts_member(of, "99.99", is->q9999);
    facts_member(of, "most", is->most);
}

static void tell_margins(const refereed *of)
{
    char name[32];
    facts_words("margins/unit", margin_unit_names[plan.told.unit]);
    for (int i = 0; i < plan.told.count; i++) {
        snprintf(name, sizeof name, "margins/wrong/%d", i);
        facts_member(name, "beyond", plan.told.list[i]);
        facts_member(name, "wrong", (double)of->beyond[i]);
    }
    facts_number("margins/most", refereed_most(of));
}

static void tell_decisions(const refereed *of)
{
    for (int i = 0; i < EVENTS; i++)
        facts_member("decisions/wrong", event_name(i), (double)of->events[i]);
    for (int i = 0; i < EVENTS; i++)
        facts_member("decisions/allowed", event_name(i), (double)of->allowed[i]);
}

/* As findings.c tells programs. */
static void tell_row(const judging_row *row)
{
    const verdict *sum = &row->sum;
    facts_clear();
    facts_words("shape", sure_shape_name(row->shape));
    facts_words("query", query_names[row->asks]);
    facts_words("regime", judging_row_name(row->which));
    facts_number("cases", (double)sum->cases);
    facts_number("valid", (double)sum->valid);
    facts_number("hits", (double)sum->hits);
    facts_number("skipped", (double)sum->skipped);
    facts_number("unasked", (double)sum->unasked);
    facts_number("wrong", (double)sum->wrong);
    facts_number("wrong_from", sum->wrong_share.lower);
    facts_number("wrong_to", sum->wrong_share.upper);
    for (int i = 0; i < FAULTS; i++)
        facts_member("faults", fault_name(i), (double)sum->faults[i]);
    tell_errors("t_ulps", &sum->t_ulps);
    tell_errors("t_relative", &sum->t_relative);
    tell_errors("t_extents", &sum->t_extents);
    tell_errors("t_pixels", &sum->t_pixels);
    tell_errors("normal_ulps", &sum->normal_ulps);
    tell_errors("normal", &sum->normal);
    if (plan.told.count > 0)
        tell_margins(&row->looked_at);
    tell_decisions(&row->looked_at);
}

/* Judges a row, which the facts tell then; NULL, or what is wrong. */
const char *WASM_EXPORT(judge_row)(sure_shape shape, int which, double count)
{
    judging_row *row = &rows[row_count];
    if (!judging_regime(judge, QUERY_HIT, shape, (regime)which, (uint64_t)count, row, message))
        return message;
    row_count++;
    tell_row(row);
    return NULL;
}

/* The worst cases of all rows, made simple, which asks the script; how many. */
int WASM_EXPORT(judge_worst)(void)
{
    return worst_find(judge, rows, row_count, worst);
}

/* One of them becomes the facts. */
void WASM_EXPORT(judge_worst_tell)(int i)
{
    const worst_case *one = &worst[i];
    const example_lines lines = example_lines_of(&one->found);
    facts_clear();
    facts_words("kind", worst_name(one->kind));
    facts_words("shape", sure_shape_name(one->shape));
    facts_words("query", query_names[one->asks]);
    facts_words("regime", judging_row_name(one->which));
    facts_words("case", lines.question);
    facts_words("answer", lines.given);
    facts_words("right", lines.right);
    if (one->kind >= FAULTS)
        facts_number("ulps", worst_size(one->kind, &one->found, one->in));
    if (one->margin > 0)
        facts_number("margin", one->margin);
    if (worst_event(one))
        facts_words("event", worst_event(one));
}

/* What it says where conventions differ, of a shape that was judged, becomes the facts. */
void WASM_EXPORT(judge_conventions)(sure_shape shape)
{
    convention_words said;
    facts_clear();
    if (!conventions_ask(judge, shape, &said))
        return;
    for (int i = 0; i < CONVENTIONS; i++) {
        char name[48];
        if (!*said.candidate[i])
            continue;
        snprintf(name, sizeof name, "%s/says", convention_name((convention)i));
        facts_words(name, said.candidate[i]);
        snprintf(name, sizeof name, "%s/contract", convention_name((convention)i));
        facts_words(name, said.contract[i]);
    }
}

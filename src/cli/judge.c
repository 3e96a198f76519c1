/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../judge/bench/instructions.h"
#include "../judge/judging.h"
#include "../support/pieces/cut.h"

#include <surehit/version.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_COUNT 2000

static judging_plan plan = {.count = DEFAULT_COUNT,
                            .surehit = {"surehit", SUREHIT_VERSION_TEXT, SUREHIT_FLAGS},
                            .how = {INPUTS_AS_IT_TAKES, CANDIDATE_TIME_LIMIT, .once = false}};
static margin_unit unit = MARGIN_SIZE;
static const char *numbered, *queried; /* options that were given */

/* The option's name says what kind of candidate it is. */
static const char *read_subject(const cli_option *row, const char *value)
{
    static const char *const names[] = {[SUBJECT_TIER] = "tier",
                                        [SUBJECT_LIBRARY] = "candidate",
                                        [SUBJECT_COMMAND] = "command",
                                        [SUBJECT_ANSWERS] = "answers"};
    subject_kind kind = SUBJECT_TIER;
    if (plan.subject != SUBJECT_NONE)
        return "one candidate, not a second candidate";
    while (strcmp(row->name, names[kind]) != 0)
        kind++;
    const char *expected = kind == SUBJECT_TIER ? cli_tier(row, value) : NULL;
    if (!expected) {
        plan.subject = kind;
        plan.name = value;
    }
    return expected;
}

static const char *read_promises(const cli_option *row, const char *value)
{
    return promises_read(value, row->to)
               ? NULL
               : "a list of decisions, decisions@1e-9, contract, t<=Nulp, ...";
}

/* Margins that promises name are told, too. */
static bool add_margins(void)
{
    for (int i = 0; i < plan.required.count; i++) {
        double margin = plan.required.list[i].margin;
        if (margin > 0 && (plan.told.unit == MARGIN_NONE || !margins_add(&plan.told, margin)))
            return false;
    }
    return true;
}

static int run(void)
{
    plan.told = margins_of(unit);
    plan.some_queries = queried != NULL;
    if (!add_margins())
        return cli_wrong("a margin is required, and --margin none");
    if (plan.subject == SUBJECT_NONE)
        return cli_wrong("missing '--tier, --candidate, --command or --answers'");
    if (cut.way != CUT_NOT && (plan.cases || plan.instructions || plan.subject == SUBJECT_ANSWERS))
        return cli_wrong("cases or answers that are given, and instructions, have no pieces");
    plan.untimed |= cut.way != CUT_NOT;
    if (plan.how.keep && plan.subject != SUBJECT_COMMAND)
        return cli_wrong("--keep is for a --command");
    if (plan.cases && (numbered || plan.rows.set))
        return cli_wrong("cases are given and to be made: '%s'", plan.cases);
    int status = cli_rows_numbers(&plan.rows, numbered, &plan.count, &plan.seed);
    if (status != 0)
        return status;
    if (plan.instructions &&
        (plan.subject > SUBJECT_LIBRARY || (plan.cases && strcmp(plan.cases, "-") == 0)))
        return cli_wrong("instructions are counted of tiers and libraries, cases not from '-'");
    if (plan.cases && strcmp(plan.cases, "-") == 0 && plan.subject == SUBJECT_ANSWERS &&
        strcmp(plan.name, "-") == 0)
        return cli_wrong("cases and answers can't both be '-'");
    bool is_file = plan.subject == SUBJECT_LIBRARY || plan.subject == SUBJECT_ANSWERS;
    const char *outputs[] = {plan.json, plan.junit, plan.sarif};
    const char *inputs[] = {plan.cases, is_file ? plan.name : NULL};
    const cli_paths all = {outputs, inputs, 3, 2};
    status = cut.way == CUT_WORK ? 0 : cli_paths_check(&all); /* a piece has none of them */
    if (status != 0)
        return status;
    if (plan.instructions && !instructions_begin(cli_running->name))
        return EXIT_OUTPUT;
    if (instructions_counting()) {
        plan.count = plan.count < INSTRUCTIONS_CASES ? plan.count : INSTRUCTIONS_CASES;
        plan.json = plan.junit = plan.sarif = NULL;
    }
    return judging_run(&plan);
}

static const char *const truths[] = {"exact", "reference", NULL};
static const char *const inputs[] = {"float", "double", NULL};

static const cli_option options[] = {
    {NULL, .help = "The candidate, one of:"},
    {"tier", "TIER", NULL, read_subject, .to = &plan.tier},
    {"candidate", "FILE", "a shared library (surehit/candidate.h says what it defines)",
     .read = read_subject},
    {"command", "COMMAND", "a program that reads case lines and writes answer lines",
     .read = read_subject},
    {"keep", NULL, "the program is kept running (docs/coprocess.md)", cli_flag,
     .to = &plan.how.keep},
    {"answers", "FILE", "answer lines that it wrote before; - is standard input",
     .read = read_subject},
    {NULL, .help = "The cases:"},
    {"cases", "FILE",
     "case lines, which may name their regime (surehit cases --named); - is standard input. "
     "Otherwise they are made",
     cli_text, .to = &plan.cases},
    {"shape", "SHAPE", "of this shape (default: all that the candidate answers); may be repeated",
     cli_shape, .to = &plan.rows},
    {"regime", "REGIME", "the kind of cases (default: all); may be repeated", cli_regime,
     .to = &plan.rows},
    {"count", "N", "of each shape and regime (default " CLI_NUMERAL(DEFAULT_COUNT) ")", cli_number,
     .to = &plan.count, .least = 1, .most = UINT64_MAX, .given = &numbered},
    {"seed", "K", "others of the same kind (default 0)", cli_number, .to = &plan.seed,
     .most = INT64_MAX, .given = &numbered},
    CLI_SET(&plan.rows),
    {NULL, .help = "The judgement:"},
    {"query", "QUERY",
     "what is asked: hit, occluded, interval or inside (default: all that a library answers, hits "
     "of "
     "others); may be repeated",
     cli_mark, .to = plan.queries, .words = query_names, .given = &queried},
    {"entry", "WORDS",
     "conditions that the cases keep, and conventions (docs/judge.md): unit, local, ray, "
     "wall, touch=miss, ... (default: as a shared library declares)",
     cli_entry, .to = &plan.how.entry},
    {"margin", "UNIT",
     "how far wrong decisions are from right, in the object's size (default), the distance, "
     "length, "
     "ulps, or growth of the object; or none",
     cli_word, .to = &unit, .words = margin_unit_names},
    {"truth", "KIND", "exact, the library's tier (default), or reference, by CGAL", cli_word,
     .to = &plan.by_reference, .words = truths},
    {"inputs", "KIND",
     "float: the candidate computes in float, its cases are rounded first; or double (default: as "
     "the shared library has its functions)",
     cli_word, .to = &plan.how.inputs, .words = inputs},
    {"time-limit", "S",
     "seconds for the answer to a case, and for what crashes cost in a row of cases "
     "(default " CLI_NUMERAL(CANDIDATE_TIME_LIMIT) ")",
     cli_seconds, .to = &plan.how.time_limit},
    {"require", "LIST",
     "promises, separated by commas: decisions, decisions<=SHARE, decisions@MARGIN, contract, "
     "t<=Nulp, "
     "t<=RELATIVE, normal<=Nulp, normal<=X",
     read_promises, .to = &plan.required},
    {"untimed", NULL, "no times are taken: the same answers are the same JSON", cli_flag,
     .to = &plan.untimed},
    CLI_INSTRUCTIONS(&plan.instructions),
    {"json", "FILE", "everything, for programs", cli_text, .to = &plan.json},
    {"junit", "FILE", "a test case for each row and promise, as JUnit's XML", cli_text,
     .to = &plan.junit},
    {"sarif", "FILE", "breaches and broken promises, as SARIF", cli_text, .to = &plan.sarif},
    {0},
};

const cli_command command_judge = {
    .name = "surehit judge",
    .summary = "hold anyone's routine against the right answers",
    .usage = "CANDIDATE [OPTION ...]",
    .about = "Asks a routine for ray-surface intersections many cases and holds its answers\n"
             "against the right ones: wrong decisions, errors of t and normal, breaches of the\n"
             "contract, time, and the worst cases, made simple.",
    .options = options,
    .cut_output = "--json",
    .print_more = cli_print_sets,
    .statuses = "0 judged, and what was required is kept; 1 it is not, or output\n"
                "could not be written; 2 wrong usage, or no candidate, cases, answers or truth.",
    .run = run,
};

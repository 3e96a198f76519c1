#include "options.h"

#include "../judge/judging_run.h"
#include "../support/atomic_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_COUNT 2000
#define DEFAULT_TIME_LIMIT 5
#define MOST_TIME_LIMIT 3600

static const char *take_subject(const cli_option *row, const char *value, subject_kind kind)
{
    judging_plan *plan = row->to;
    if (plan->subject != SUBJECT_NONE)
        return "one candidate, not a second candidate";
    plan->subject = kind;
    plan->name = value;
    return NULL;
}

static const char *read_tier(const cli_option *row, const char *value)
{
    judging_plan *plan = row->to;
    const char *expected = take_subject(row, value, SUBJECT_TIER);
    return expected || sure_tier_from_name(value, &plan->tier) ? expected : cli_tier_names();
}

static const char *read_library(const cli_option *row, const char *value)
{
    return take_subject(row, value, SUBJECT_LIBRARY);
}

static const char *read_command(const cli_option *row, const char *value)
{
    return take_subject(row, value, SUBJECT_COMMAND);
}

static const char *read_answers(const cli_option *row, const char *value)
{
    return take_subject(row, value, SUBJECT_ANSWERS);
}

static const char *read_seconds(const cli_option *row, const char *value)
{
    char *end;
    double seconds = strtod(value, &end);
    if (*end != '\0' || !(seconds >= 0.001 && seconds <= MOST_TIME_LIMIT))
        return "seconds from 0.001 to " CLI_NUMERAL(MOST_TIME_LIMIT);
    *(double *)row->to = seconds;
    return NULL;
}

static const char *read_promises(const cli_option *row, const char *value)
{
    return promises_read(value, row->to) ? NULL : "a list of decisions, contract, t<=Nulp, ...";
}

static int check(const cli_command *command, const judging_plan *plan, const char *made)
{
    if (plan->subject == SUBJECT_NONE)
        return cli_wrong(command, "missing", "--tier, --candidate, --command or --answers");
    if (plan->cases && made)
        return cli_wrong(command, "cases are given and to be made:", plan->cases);
    if (plan->cases && strcmp(plan->cases, "-") == 0 && plan->subject == SUBJECT_ANSWERS &&
        strcmp(plan->name, "-") == 0)
        return cli_wrong(command, "cases and answers can't both be", "-");
    return 0;
}

static int judge(judging_plan *plan, const cli_rows *rows)
{
    static const int statuses[] = {
        [JUDGED] = 0,
        [JUDGED_BROKEN] = 1,
        [JUDGED_UNWRITTEN] = EXIT_OUTPUT,
        [JUDGED_NOTHING] = EXIT_USAGE,
    };
    if (plan->json && !atomic_file_possible(plan->json, stderr))
        return EXIT_OUTPUT;
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++)
        plan->wanted[i / REGIMES][i % REGIMES] = cli_rows_have(rows, i / REGIMES, i % REGIMES);
    memcpy(plan->named, rows->shapes, sizeof plan->named);
    return statuses[judging_run(plan, stdout)];
}

int command_judge(int count, char **words)
{
    static const char *const truths[] = {"exact", "reference", NULL};
    static const char *const inputs[] = {"float", "double", NULL};
    static const candidate_inputs in_of[] = {INPUTS_FLOAT, INPUTS_DOUBLE, INPUTS_AS_IT_TAKES};
    judging_plan plan = {.count = DEFAULT_COUNT, .how = {.time_limit = DEFAULT_TIME_LIMIT}};
    cli_rows rows = {.some_shapes = false};
    const char *made = NULL; /* an option that says which cases */
    int known = 0, in = 2, status;
    const cli_option options[] = {
        {NULL, .help = "The candidate, one of:"},
        {"tier", "TIER", cli_tier_names(), read_tier, .to = &plan},
        {"candidate", "FILE", "a shared library (surehit/candidate.h says what it defines)",
         read_library, .to = &plan},
        {"command", "COMMAND", "a program that reads case lines and writes answer lines",
         read_command, .to = &plan},
        {"answers", "FILE", "answer lines that it wrote before; - is standard input", read_answers,
         .to = &plan},
        {NULL, .help = "The cases:"},
        {"cases", "FILE", "case lines; - is standard input. Otherwise they are made:", cli_text,
         .to = &plan.cases},
        {"shape", "SHAPE",
         "of this shape (default: all that the candidate answers); may be repeated", cli_shape,
         .to = &rows, .given = &made},
        {"regime", "REGIME", "the kind of cases (default: all); may be repeated", cli_regime,
         .to = &rows, .given = &made},
        {"count", "N", "of each shape and regime (default " CLI_NUMERAL(DEFAULT_COUNT) ")",
         cli_number, .to = &plan.count, .least = 1, .most = UINT64_MAX, .given = &made},
        {"seed", "K", "others of the same kind (default 0)", cli_number, .to = &plan.seed,
         .most = INT64_MAX, .given = &made},
        {NULL, .help = "The judgement:"},
        {"truth", "KIND", "exact, the library's tier (default), or reference, by CGAL", cli_word,
         .to = &known, .words = truths},
        {"inputs", "KIND",
         "float: the candidate computes in float, its cases are rounded first; or double "
         "(default: as the shared library has its functions)",
         cli_word, .to = &in, .words = inputs},
        {"time-limit", "S",
         "seconds for the answer to a case (default " CLI_NUMERAL(DEFAULT_TIME_LIMIT) ")",
         read_seconds, .to = &plan.how.time_limit},
        {"require", "LIST",
         "promises, separated by commas: decisions, decisions<=SHARE, contract, t<=Nulp, "
         "t<=RELATIVE, normal<=Nulp, normal<=X",
         read_promises, .to = &plan.required},
        {"json", "FILE", "everything, for programs", cli_text, .to = &plan.json},
        {0},
    };
    const cli_command command = {
        .name = "surehit judge",
        .usage = "CANDIDATE [OPTION ...]",
        .about =
            "Asks a routine for ray-surface intersections many cases and holds its answers\n"
            "against the right ones: wrong decisions, errors of t and normal, breaches of the\n"
            "contract, time, and the worst cases, made simple.",
        .options = options,
        .print_more = cli_print_regimes,
        .statuses =
            "0 judged, and what was required is kept; 1 it is not, or output\n"
            "could not be written; 2 wrong usage, or no candidate, cases, answers or truth.",
    };
    if (!cli_read(&command, count, words, &status))
        return status;
    plan.by_reference = known == 1;
    plan.how.inputs = in_of[in];
    status = check(&command, &plan, made);
    return cli_finish(&command, status == 0 ? judge(&plan, &rows) : status);
}

/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../judge/walks/walk.h"

#include <math.h>
#include <stdlib.h>

#define DEFAULT_STEPS 100000
#define DEFAULT_NUDGE 1e-9

static walk_plan plan = {.how = {INPUTS_AS_IT_TAKES, CANDIDATE_TIME_LIMIT, .once = false},
                         .by.nudge = NAN,
                         .steps = DEFAULT_STEPS};
static const char *tier;

static const char *read_nudge(const cli_option *row, const char *value)
{
    char *end;
    double nudge = strtod(value, &end);
    if (*end != '\0' || end == value || !(nudge >= 0 && isfinite(nudge)))
        return "a length of 0 or more";
    *(double *)row->to = nudge;
    return NULL;
}

static int run(void)
{
    if (!tier == !plan.library)
        return cli_wrong("one of '--tier and --candidate'");
    if (isnan(plan.by.nudge) && (plan.library || plan.by.tier < SURE_TIER_CERTAIN))
        plan.by.nudge = DEFAULT_NUDGE;
    const char *const outputs[] = {plan.json}, *const inputs[] = {plan.library};
    const cli_paths all = {outputs, inputs, 1, 1};
    int status = cli_paths_check(&all);
    return status == 0 ? walk_run(&plan) : status;
}

static const char *const truths[] = {"exact", "reference", NULL};

static const cli_option options[] = {
    {NULL, .help = "Who walks, one of:"},
    {"tier", "TIER", NULL, cli_tier, .to = &plan.by.tier, .given = &tier},
    {"candidate", "FILE", "a shared library (surehit/candidate.h says what it defines)", cli_text,
     .to = &plan.library},
    {"nudge", "LENGTH",
     "it starts again so far behind its answer, on its way (default: certain and exact where "
     "sure_spawn tells, others 1e-9)",
     read_nudge, .to = &plan.by.nudge},
    {NULL, .help = "Where:"},
    {"shape", "SHAPE", "in solids of this shape (default: all); may be repeated", cli_shape,
     .to = &plan.rows},
    {"kind", "KIND", NULL, cli_mark, .to = plan.kinds, .words = walk_kind_names},
    {"steps", "N", "of each shape and kind (default " CLI_NUMERAL(DEFAULT_STEPS) ")", cli_number,
     .to = &plan.steps, .least = 1, .most = UINT64_MAX},
    {"seed", "K", "others of the same kind (default 0)", cli_number, .to = &plan.seed,
     .most = INT64_MAX},
    {NULL, .help = "The judgement:"},
    {"truth", "KIND", "exact, the library's tier (default), or reference, by CGAL", cli_word,
     .to = &plan.by_reference, .words = truths},
    {"require", NULL, "no fault, else status 1", cli_flag, .to = &plan.required},
    CLI_THREADS(&plan.threads),
    {"json", "FILE", "everything, for programs", cli_text, .to = &plan.json},
    {0},
};

const cli_command command_walk = {
    .name = "surehit walk",
    .summary = "go from hit to hit by anyone's routine, and count what goes wrong",
    .usage = "(--tier TIER | --candidate FILE) [OPTION ...]",
    .about = "Asks a routine for the first hit, goes there, and asks again from the rounded\n"
             "point, in or out or back, as particles go; every answer and every start is held\n"
             "against the truth. One fault ends a walk, and the next begins.",
    .options = options,
    .statuses = "0 walked, and what was required is kept; 1 it is not, or output\n"
                "could not be written; 2 wrong usage, or no candidate or truth.",
    .run = run,
};

/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../cases/lines.h"
#include "../judge/candidates/candidate.h"

#include <stdio.h>

#define TIME_LIMIT 60 /* seconds for an answer */

static sure_tier tier = SURE_TIER_EXACT;
static const char *library;

static void by_tier(const sure_case *question)
{
    char text[CASE_LINE_MAX];
    case_answer answer = case_answer_of(question, tier);
    case_answer_print(&answer, text);
    puts(text);
}

/* 0, or the exit status after a complaint: it did not answer. */
static int by_library(candidate *asked, const sure_case *question, uintmax_t number)
{
    static block one;
    char text[CASE_LINE_MAX];
    one.shape = question->object.shape;
    one.count = 1;
    one.cases[0] = *question;
    if (!asked->answers[QUERY_HIT][one.shape])
        return cli_wrong("line %ju: the candidate answers no %s", number,
                         sure_shape_name(one.shape));
    candidate_forgive(asked);
    candidate_ask(asked, &one);
    one.replies[0].to = QUERY_HIT; /* which can be read again, whoever only decides */
    reply_print(&one.replies[0], text);
    if (one.replies[0].kind <= REPLY_GARBAGE)
        return puts(text) < 0;
    fprintf(stderr, "%s: error: line %ju: %s\n", cli_running->name, number, text);
    return EXIT_OUTPUT;
}

static int answer_lines(candidate *asked, case_lines *lines)
{
    int status = 0;
    while (status == 0 && !ferror(stdout) && case_lines_next(lines)) {
        sure_case question;
        if (!lines->whole || !case_read(lines->text, &question))
            puts("invalid line");
        else if (asked)
            status = by_library(asked, &question, lines->number);
        else
            by_tier(&question);
    }
    return status;
}

static int run(void)
{
    const candidate_options how = {INPUTS_AS_IT_TAKES, .time_limit = TIME_LIMIT, .once = true};
    char message[CANDIDATE_MESSAGE];
    candidate *asked = library ? candidate_of_library(library, &how, message) : NULL;
    if (library && !asked)
        return cli_wrong("%s", message);
    case_lines lines = {.in = stdin};
    int status = answer_lines(asked, &lines);
    candidate_close(asked);
    const char *wrong = case_lines_fault(&lines);
    if (wrong)
        return cli_wrong("the cases cannot be read after line %ju: %s", lines.number, wrong);
    return status;
}

static const cli_option options[] = {
    {"tier", "TIER", NULL, cli_tier, .to = &tier},
    {"candidate", "FILE", "a shared library (surehit/candidate.h) in the tier's place", cli_text,
     .to = &library},
    {0},
};

const cli_command command_answer = {
    .name = "surehit answer",
    .summary = "read cases and write a tier's answers",
    .usage = "[--tier TIER | --candidate FILE]",
    .about = "Reads cases, one a line (see `surehit cases`), and writes an answer to each:\n"
             "\n"
             "  miss\n"
             "  hit <t> <part> <nx> <ny> <nz>\n"
             "  invalid <field>\n"
             "\n"
             "A line that is no case is answered `invalid line`. The default tier is exact.\n"
             "A candidate is asked each line as it stands; what it does not say is left out.\n"
             "Its status that is none is answered `garbage: 'status N'`.",
    .options = options,
    .statuses = "0 answered; 1 the candidate crashed or gave no answer, at the line\n"
                "that is named, or output could not be written; 2 wrong usage, no\n"
                "candidate, a shape that it lacks, or the cases can't be read.",
    .run = run,
};

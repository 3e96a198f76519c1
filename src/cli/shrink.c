/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../cases/lines.h"
#include "../judge/shrink.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#define NAME "surehit shrink"

static int tier = -1, by = AGAINST_DECISION;

static void shrink_line(uintmax_t number, const sure_case *question)
{
    char text[CASE_LINE_MAX];
    sure_case simple;
    if (!tier_failure_simple(question, (sure_tier)tier, (against)by, &simple)) {
        fprintf(stderr, NAME ": line %ju: does not fail\n", number);
        return;
    }
    case_print(&simple, text);
    puts(text);
}

/* The exit status. */
static int shrink_lines(FILE *in)
{
    case_lines lines = {.in = in};
    int status = 0;
    while (!ferror(stdout) && case_lines_next(&lines)) {
        sure_case question;
        if (lines.whole && case_read(lines.text, &question)) {
            shrink_line(lines.number, &question);
            continue;
        }
        fprintf(stderr, NAME ": error: line %ju: no case\n", lines.number);
        status = EXIT_USAGE;
    }
    if (case_lines_fault(&lines)) {
        fprintf(stderr, NAME ": error: the cases cannot be read after line %ju: %s\n", lines.number,
                case_lines_fault(&lines));
        status = EXIT_USAGE;
    }
    return status;
}

static int run(void)
{
    const char *path = cli_operand_count > 0 ? cli_operands[0] : "-";
    if (tier < 0)
        return cli_wrong("missing '--tier'");
    if (by == AGAINST_PROMISE && tier != SURE_TIER_CERTAIN)
        return cli_wrong("--against 'promise': expected the tier certain");
    FILE *in = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
    if (!in) {
        fprintf(stderr, NAME ": error: %s: %s\n", path, strerror(errno));
        return EXIT_USAGE;
    }
    int status = shrink_lines(in);
    if (in != stdin)
        fclose(in);
    return status;
}

static const char *const kinds[] = {
    [AGAINST_DECISION] = "decision",
    [AGAINST_ANSWER] = "answer",
    [AGAINST_PROMISE] = "promise",
    NULL,
};

static const cli_option options[] = {
    {"tier", "TIER", "any but exact", cli_fallible_tier, .to = &tier},
    {"against", "WHAT",
     "what is held against the tier exact: decision (the default): status, field and part; answer: "
     "every bit of the answer; promise: what certain promises, the decision, t in range and within "
     "t_error, the normal's bound",
     cli_word, .to = &by, .words = kinds},
    {0},
};

const cli_command command_shrink = {
    .name = NAME,
    .summary = "make cases that a tier answers wrongly simple",
    .usage = "--tier TIER [--against WHAT] [FILE]",
    .about = "Reads cases, one a line, from FILE or standard input. Each one that TIER\n"
             "answers wrongly is made simple (zeros, ones, fewer bits, smaller exponents) as\n"
             "long as it is answered wrongly in the same way, and printed. What is answered\n"
             "rightly, and what is no case, is told on standard error.",
    .options = options,
    .most_operands = 1,
    .statuses = "0 every line was a case; 1 output could not be written; 2 wrong\n"
                "usage, or a line that is no case.",
    .run = run,
};

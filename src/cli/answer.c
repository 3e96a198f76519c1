#include "options.h"

#include "../cases/case.h"

#include <stdio.h>
#include <string.h>

/* The rest of a line that was longer than any case. */
static void skip_line(FILE *in)
{
    int c;
    do
        c = fgetc(in);
    while (c != '\n' && c != EOF);
}

static sure_tier tier = SURE_TIER_EXACT;

static int run(void)
{
    char line[CASE_LINE_MAX + 2], text[CASE_LINE_MAX];
    while (fgets(line, sizeof line, stdin) && !ferror(stdout)) {
        sure_case question;
        bool whole = strchr(line, '\n') || strlen(line) < sizeof line - 1;
        if (!whole)
            skip_line(stdin);
        if (!whole || !case_read(line, &question)) {
            puts("invalid line");
            continue;
        }
        case_answer answer = case_answer_of(&question, tier);
        case_answer_print(&answer, text);
        puts(text);
    }
    return 0;
}

static const cli_option options[] = {
    {"tier", "TIER", NULL, cli_tier, .to = &tier},
    {0},
};

const cli_command command_answer = {
    .name = "surehit answer",
    .summary = "read cases and write a tier's answers",
    .usage = "[--tier TIER]",
    .about = "Reads cases, one a line (see `surehit cases`), and writes an answer to each:\n"
             "\n"
             "  miss\n"
             "  hit <t> <part> <nx> <ny> <nz>\n"
             "  invalid <field>\n"
             "\n"
             "A line that is no case is answered `invalid line`. The default tier is exact.",
    .options = options,
    .statuses = "0 answered; 1 output could not be written; 2 wrong usage.",
    .run = run,
};

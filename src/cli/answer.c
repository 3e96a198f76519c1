#include "options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static sure_tier tier = SURE_TIER_EXACT;

/* A line that is longer than any case is none. */
static int run(void)
{
    char *line = NULL, text[CASE_LINE_MAX];
    size_t room = 0;
    while (getline(&line, &room, stdin) >= 0 && !ferror(stdout)) {
        sure_case question;
        if (strlen(line) > CASE_LINE_MAX || !case_read(line, &question)) {
            puts("invalid line");
            continue;
        }
        case_answer answer = case_answer_of(&question, tier);
        case_answer_print(&answer, text);
        puts(text);
    }
    free(line);
    if (ferror(stdin))
        return cli_wrong("the cases cannot be read");
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
    .statuses = "0 answered; 1 output could not be written; 2 wrong usage, or the\n"
                "cases can't be read.",
    .run = run,
};

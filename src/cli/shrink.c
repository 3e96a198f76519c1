#define _POSIX_C_SOURCE 200809L /* getline */

#include "options.h"

#include "../judge/tier_failure.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NAME "surehit shrink"

typedef struct {
    sure_tier tier;
    against by;
} request;

static void shrink_line(uint64_t number, const sure_case *question, const request *asked)
{
    char text[CASE_LINE_MAX];
    sure_case simple;
    if (!tier_failure_simple(question, asked->tier, asked->by, &simple)) {
        fprintf(stderr, NAME ": line %ju: does not fail\n", (uintmax_t)number);
        return;
    }
    case_print(&simple, text);
    puts(text);
}

/* The exit status. A NUL byte would hide what stands behind it. */
static int shrink_lines(FILE *in, const request *asked)
{
    char *text = NULL;
    size_t room = 0;
    int status = 0;
    uint64_t number = 0;
    for (ssize_t length; !ferror(stdout) && (length = getline(&text, &room, in)) >= 0;) {
        sure_case question;
        number++;
        if (strlen(text) == (size_t)length && case_read(text, &question)) {
            shrink_line(number, &question, asked);
            continue;
        }
        fprintf(stderr, NAME ": error: line %ju: no case\n", (uintmax_t)number);
        status = EXIT_USAGE;
    }
    free(text);
    if (ferror(in)) {
        fputs(NAME ": error: the cases cannot be read\n", stderr);
        status = EXIT_USAGE;
    }
    return status;
}

static int shrink_file(const char *path, const request *asked)
{
    bool is_input = !path || strcmp(path, "-") == 0;
    FILE *in = is_input ? stdin : fopen(path, "r");
    if (!in) {
        fprintf(stderr, NAME ": error: %s: %s\n", path, strerror(errno));
        return EXIT_USAGE;
    }
    int status = shrink_lines(in, asked);
    if (!is_input)
        fclose(in);
    return status;
}

int command_shrink(int count, char **words)
{
    static const char *const kinds[] = {
        [AGAINST_DECISION] = "decision",
        [AGAINST_ANSWER] = "answer",
        [AGAINST_PROMISE] = "promise",
        NULL,
    };
    request asked;
    const char *tiers[SURE_TIER_EXACT + 1] = {NULL}; /* those that can be wrong */
    const char **paths;
    int tier = -1, by = AGAINST_DECISION, path_count, status;
    for (int i = 0; i < SURE_TIER_EXACT; i++)
        tiers[i] = sure_tier_name((sure_tier)i);
    const cli_option options[] = {
        {"tier", "TIER", "any but exact", cli_word, .to = &tier, .words = tiers},
        {"against", "WHAT",
         "what is held against the tier exact: decision (the default): status, field and part; "
         "answer: every bit of the answer; promise: what certain promises, the decision, t in "
         "range and within t_error, the normal's bound",
         cli_word, .to = &by, .words = kinds},
        {0},
    };
    const cli_command command = {
        .name = NAME,
        .usage = "--tier TIER [--against WHAT] [FILE]",
        .about = "Reads cases, one a line, from FILE or standard input. Each one that TIER\n"
                 "answers wrongly is made simple (zeros, ones, fewer bits, smaller exponents) as\n"
                 "long as it is answered wrongly in the same way, and printed. What is answered\n"
                 "rightly, and what is no case, is told on standard error.",
        .options = options,
        .operands = {NULL, 1, &paths, &path_count},
        .statuses = "0 every line was a case; 1 output could not be written; 2 wrong\n"
                    "usage, or a line that is no case.",
    };
    if (!cli_read(&command, count, words, &status))
        return status;
    asked = (request){(sure_tier)tier, (against)by};
    if (tier < 0)
        return cli_wrong(&command, "missing", "--tier");
    if (asked.by == AGAINST_PROMISE && asked.tier != SURE_TIER_CERTAIN)
        return cli_wrong_value(&command, "against", "promise", "the tier certain");
    return cli_finish(&command, shrink_file(path_count > 0 ? paths[0] : NULL, &asked));
}

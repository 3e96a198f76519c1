#include "args.h"
#include "commands.h"

#include "../cases/case.h"

#include <stdio.h>
#include <string.h>

enum { HELP, TIER };
static const args_option options[] = {[HELP] = {"--help", false}, [TIER] = {"--tier", true}};
#define OPTIONS (int)(sizeof options / sizeof *options)

static void print_help(void)
{
    fputs("Usage: surehit answer [--tier TIER]\n"
          "\n"
          "Reads cases, one a line (see `surehit cases`), and writes an answer to each:\n"
          "\n"
          "  miss\n"
          "  hit <t> <part> <nx> <ny> <nz>\n"
          "  invalid <field>\n"
          "\n"
          "A line that is no case is answered `invalid line`.\n"
          "\n"
          "  --tier TIER  float32, textbook, stable, certain or exact (the default)\n"
          "\n"
          "Exit status: 0 answered; 1 output could not be written; 2 wrong usage.\n",
          stdout);
}

/* The rest of a line that was longer than any case. */
static void skip_line(FILE *in)
{
    int c;
    do
        c = fgetc(in);
    while (c != '\n' && c != EOF);
}

static void answer_lines(FILE *in, sure_tier tier)
{
    char line[CASE_LINE_MAX + 2], text[CASE_LINE_MAX];
    while (fgets(line, sizeof line, in) && !ferror(stdout)) {
        sure_case question;
        bool whole = strchr(line, '\n') || strlen(line) < sizeof line - 1;
        if (!whole)
            skip_line(in);
        if (!whole || !case_read(line, &question)) {
            puts("invalid line");
            continue;
        }
        case_answer answer = case_answer_of(&question, tier);
        case_answer_print(&answer, text);
        puts(text);
    }
}

int command_answer(int count, char **words)
{
    args line = {"surehit answer", words, count, 0, false};
    sure_tier tier = SURE_TIER_EXACT;
    const char *value;
    for (int option; (option = args_next(&line, options, OPTIONS, &value)) != ARGS_END;) {
        switch (option) {
        case HELP: print_help(); return args_flush_output(&line, 0);
        case TIER:
            if (!sure_tier_from_name(value, &tier))
                return args_wrong_value(&line, "--tier", value,
                                        "float32, textbook, stable, certain or exact");
            break;
        case ARGS_OPERAND: return args_wrong(&line, "one word too many:", value);
        default: return EXIT_USAGE;
        }
    }
    answer_lines(stdin, tier);
    return args_flush_output(&line, 0);
}

#include "args.h"
#include "commands.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *name;
    int (*run)(int count, char **words);
    const char *summary;
} commands[] = {
    {"render", command_render, "draw a scene (.rt) into a picture (.ppm, .png)"},
    {"merge", command_merge, "add shares of a picture's photons: render --integrator forward"},
    {"check", command_check, "verify the certificate of a picture, pixel by pixel"},
    {"diff", command_diff, "say where two pictures differ"},
    {"regress", command_regress, "hold a folder of scenes against their golden pictures"},
    {"cases", command_cases, "write cases, one a line: typical ones and the hard kinds"},
    {"answer", command_answer, "read cases and write a tier's answers"},
    {"judge", command_judge, "hold anyone's routine against the right answers"},
    {"report", command_report, "set routines side by side, on one page to look at"},
    {"shrink", command_shrink, "make cases that a tier answers wrongly simple"},
    {"vectors", command_vectors, "write hard cases with exact answers for anyone's tests"},
    {"bench", command_bench, "measure how long each tier takes for an answer"},
};

#define COMMANDS (sizeof commands / sizeof *commands)

static void print_help(FILE *out)
{
    fputs("Usage: surehit COMMAND ...\n"
          "\n"
          "Ray-surface intersections whose answers can be trusted.\n"
          "\n", out);
    for (size_t i = 0; i < COMMANDS; i++)
        fprintf(out, "  %-10s  %s\n", commands[i].name, commands[i].summary);
    fputs("\n"
          "  surehit COMMAND --help  what the command takes\n"
          "  surehit --version       prints the version\n", out);
}

enum { HELP, VERSION };
static const args_option options[] = {[HELP] = {"--help", false}, [VERSION] = {"--version", false}};
#define OPTIONS (int)(sizeof options / sizeof *options)

int main(int count, char **words)
{
    if (count < 2) {
        print_help(stderr);
        return EXIT_USAGE;
    }
    for (size_t i = 0; i < COMMANDS; i++) {
        if (strcmp(words[1], commands[i].name) == 0)
            return commands[i].run(count - 2, words + 2);
    }
    args line = {"surehit", words + 1, count - 1, 0, false};
    const char *word;
    switch (args_next(&line, options, OPTIONS, &word)) {
    case HELP: print_help(stdout); return args_flush_output(&line, 0);
    case VERSION: puts("surehit " SUREHIT_VERSION); return args_flush_output(&line, 0);
    case ARGS_OPERAND: return args_wrong(&line, "unknown command", word);
    case ARGS_END: return args_wrong(&line, "no command after", "--");
    }
    return EXIT_USAGE;
}

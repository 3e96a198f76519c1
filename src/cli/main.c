#include "options.h"

#include <limits.h>
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

static void print_commands(FILE *out)
{
    fputs("\nCommands; `surehit COMMAND --help` says what each takes:\n", out);
    for (size_t i = 0; i < COMMANDS; i++)
        fprintf(out, "  %-10s  %s\n", commands[i].name, commands[i].summary);
}

int main(int count, char **words)
{
    bool version = false;
    const cli_option options[] = {
        {"version", NULL, "print the version", cli_flag, .to = &version},
        {0},
    };
    const cli_command surehit = {
        .name = "surehit",
        .usage = "COMMAND ...",
        .about = "Ray-surface intersections whose answers can be trusted.",
        .options = options,
        .operands = {.most = INT_MAX},
        .print_more = print_commands,
    };
    int status;
    if (count < 2) {
        cli_print_help(&surehit, stderr);
        return EXIT_USAGE;
    }
    for (size_t i = 0; i < COMMANDS; i++) {
        if (strcmp(words[1], commands[i].name) == 0)
            return commands[i].run(count - 2, words + 2);
    }
    if (words[1][0] != '-')
        return cli_wrong(&surehit, "unknown command", words[1]);
    if (!cli_read(&surehit, count - 1, words + 1, &status))
        return status;
    if (!version)
        return cli_wrong(&surehit, "no command after", words[1]);
    puts("surehit " SUREHIT_VERSION);
    return cli_finish(&surehit, 0);
}

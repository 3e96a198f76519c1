#include "options.h"

#include <surehit/version.h>

#include <limits.h>
#include <stdio.h>
#include <string.h>

static const cli_command *const commands[] = {
    &command_render, &command_merge,   &command_check, &command_diff, &command_regress,
    &command_cases,  &command_answer,  &command_judge, &command_walk, &command_report,
    &command_shrink, &command_vectors, &command_bench,
};
#define COMMANDS (sizeof commands / sizeof *commands)

/* "check" of "surehit check". */
static const char *word_of(const cli_command *command)
{
    return strchr(command->name, ' ') + 1;
}

static void print_commands(FILE *out)
{
    fputs("\nCommands; `surehit COMMAND --help` says what each takes:\n", out);
    for (size_t i = 0; i < COMMANDS; i++)
        fprintf(out, "  %-10s  %s\n", word_of(commands[i]), commands[i]->summary);
}

static bool version;
static int run(void);

static const cli_option options[] = {
    {"version", NULL, "print the version", cli_flag, .to = &version},
    {0},
};

static cli_command surehit = {
    .name = "surehit",
    .usage = "COMMAND ...",
    .about = "Ray-surface intersections whose answers can be trusted.",
    .options = options,
    .most_operands = INT_MAX,
    .print_more = print_commands,
    .run = run,
};

static int run(void)
{
    if (!version)
        return cli_wrong("no command after '--'");
    puts("surehit " SUREHIT_VERSION_TEXT);
    return 0;
}

int main(int count, char **words)
{
    for (size_t i = 0; count > 1 && i < COMMANDS; i++) {
        if (strcmp(words[1], word_of(commands[i])) == 0)
            return cli_run(commands[i], count - 1, words + 1);
    }
    cli_running = &surehit;
    if (count < 2)
        surehit.run = NULL;
    else if (words[1][0] != '-')
        return cli_wrong("unknown command '%s'", words[1]);
    return cli_run(&surehit, count, words);
}

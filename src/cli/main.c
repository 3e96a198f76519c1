/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <surehit/version.h>

#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

const cli_command *const cli_commands[] = {
    &command_render,
    &command_merge,
    &command_check,
    &command_diff,
    &command_regress,
    &command_cases,
    &command_answer,
    &command_judge,
    &command_walk,
    &command_report,
    &command_shrink,
    &command_vectors,
    &command_bench,
    &command_plan,
    &command_work,
    &command_status,
    NULL,
};

const char *cli_word_of(const cli_command *command)
{
    return strchr(command->name, ' ') + 1;
}

static void print_commands(FILE *out)
{
    fputs("\nCommands; `surehit COMMAND --help` says what each takes:\n", out);
    for (int i = 0; cli_commands[i]; i++)
        fprintf(out, "  %-10s  %s\n", cli_word_of(cli_commands[i]), cli_commands[i]->summary);
}

const cli_command *cli_command_of(const char *word)
{
    for (int i = 0; cli_commands[i]; i++) {
        if (strcmp(word, cli_word_of(cli_commands[i])) == 0)
            return cli_commands[i];
    }
    return strcmp(word, cli_word_of(&command_describe)) == 0 ? &command_describe : NULL;
}

static bool version;
static int run(void);

static const cli_option options[] = {
    {"version", NULL, "print the version", cli_flag, .to = &version},
    {0},
};

const cli_command cli_program = {
    .name = "surehit",
    .summary = "ray-surface intersections whose answers can be trusted",
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

static int run_command(const char *word, int count, char **words)
{
    const cli_command *command = cli_command_of(word);
    if (command)
        return cli_run(command, count, words);
    cli_running = &cli_program;
    return cli_wrong("unknown command '%s'", word);
}

/* `help` and `help COMMAND` are `--help` and `COMMAND --help`. */
static int help(int count, char **words)
{
    static char option[] = "--help";
    char *asked[] = {words[0], option, NULL};
    if (count == 0)
        return cli_run(&cli_program, 2, asked);
    if (count == 1)
        return run_command(words[1], 2, asked);
    cli_running = &cli_program;
    return cli_wrong("one word too many: '%s'", words[2]);
}

/* A stream that was closed stays one that can't be used, but its number is taken: no pipe gets it,
 * which a child would lose. */
static void take_numbers_of_streams(void)
{
    for (int i = STDIN_FILENO; i <= STDERR_FILENO; i++) {
        if (fcntl(i, F_GETFD) < 0)
            (void)!open("/dev/null", i == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

int main(int count, char **words)
{
    cli_command surehit = cli_program;
    take_numbers_of_streams();
    cli_running = &cli_program;
    if (count > 1 && strcmp(words[1], "help") == 0)
        return help(count - 2, words + 1);
    if (count > 1 && words[1][0] != '-')
        return run_command(words[1], count - 1, words + 1);
    if (count < 2)
        surehit.run = NULL;
    return cli_run(&surehit, count, words);
}

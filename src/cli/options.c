/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../support/atomic_file.h"
#include "../support/folder.h"
#include "../support/pieces/cut.h"
#include "../support/printable.h"

#include <errno.h>
#include <limits.h>
#include <popt.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#define ROWS_MOST 64
#define GROUPS_MOST 8

/* A call of the library takes up to 0.6 MB of it, in any thread. */
#define STACK_LEAST (1024 * 1024)

const cli_command *cli_running;
char *const *cli_words;
const char **cli_operands;
int cli_operand_count;

int cli_wrong(const char *format, ...)
{
    va_list values;
    fprintf(stderr, "%s: error: ", cli_running->name);
    va_start(values, format);
    printable_vprint(stderr, format, values);
    va_end(values);
    fprintf(stderr, "; see '%s --help'\n", cli_running->name);
    return EXIT_USAGE;
}

/* Where a path's last word begins; its folder goes to `folder`. */
static const char *last_word(const char *path, char folder[PATH_MAX])
{
    const char *slash = strrchr(path, '/');
    snprintf(folder, PATH_MAX, "%.*s", slash ? (int)(slash + 1 - path) : 2, slash ? path : "./");
    return slash ? slash + 1 : path;
}

/* Files may be there or not. */
static bool is_same_place(const char *path, const char *other)
{
    char folder[PATH_MAX], other_folder[PATH_MAX];
    return folder_is_same_file(path, other) ||
           (strcmp(last_word(path, folder), last_word(other, other_folder)) == 0 &&
            (strcmp(folder, other_folder) == 0 || folder_is_same_file(folder, other_folder)));
}

static bool is_taken(const char *path, const char *const *paths, int count)
{
    int i = 0;
    while (i < count && !(paths[i] && is_same_place(path, paths[i])))
        i++;
    return i < count;
}

/* Results that are being merged are read by whatever command goes on from them; a manifest is
 * there before what it plans is. */
static bool is_of_pieces(const char *path)
{
    if (cut.way == CUT_PLAN)
        return is_same_place(path, cut.manifest);
    return cut.way == CUT_MERGE &&
           is_taken(path, (const char *const *)cut.results->names, cut.results->count);
}

int cli_paths_check(const cli_paths *all)
{
    for (int i = 0; i < all->output_count; i++) {
        const char *path = all->outputs[i];
        if (path && strcmp(path, "-") == 0)
            return cli_wrong("'-': this is written to a file that has a name");
        if (path && (is_taken(path, all->inputs, all->input_count) ||
                     is_taken(path, all->outputs, i) || is_of_pieces(path)))
            return cli_wrong("'%s' may not take the place of a file that is read, or of another",
                             path);
        if (!atomic_file_possible(path, stderr))
            return EXIT_OUTPUT;
    }
    return 0;
}

/* A copy that lives as long as the program. */
static const char *keep(char *value)
{
    static struct kept {
        struct kept *before;
        char *value;
    } * last;
    struct kept *next = malloc(sizeof *next);
    if (!next)
        abort();
    *next = (struct kept){last, value};
    last = next;
    return value;
}

/* The table as popt's: a table a heading, and one that includes them all. */

#define HELP INT_MAX /* what popt returns for --help; for another row, its number and 1 */

typedef struct {
    struct poptOption rows[ROWS_MOST], groups[GROUPS_MOST + 1];
    int row_count, group_count;
} tables;

static void begin_group(tables *all, const char *heading)
{
    all->row_count++; /* the one before ends with a row of zeros */
    all->groups[all->group_count++] = (struct poptOption){
        .argInfo = POPT_ARG_INCLUDE_TABLE, .arg = &all->rows[all->row_count], .descrip = heading};
}

const cli_option cli_help = {.name = "help", .help = "print this text"};

const char *cli_dashes(const cli_option *row)
{
    return row->name[1] == '\0' ? "-" : "--";
}

const char *cli_help_of(const cli_option *row)
{
    return row->help ? row->help : keep(strdup(row->read(row, "")));
}

static void add_row(tables *all, const cli_option *row, int number)
{
    bool is_short = row->name[1] == '\0';
    char letter = is_short ? row->name[0] : number == HELP ? 'h' : '\0';
    all->rows[all->row_count++] =
        (struct poptOption){.longName = is_short ? NULL : row->name,
                            .shortName = letter,
                            .argInfo = row->value ? POPT_ARG_STRING : POPT_ARG_NONE,
                            .val = number,
                            .descrip = cli_help_of(row),
                            .argDescrip = row->value};
}

/* popt's reader of the words, in which the command is called by its name. */
static poptContext reader_of(const cli_command *command, int count, char **words)
{
    static tables all; /* lives as long as the reader, that is until another command is run */
    static poptContext reader;
    const char **named = (const char **)words;
    const cli_option *row = command->options;
    all = (tables){.row_count = 0};
    named[0] = command->name;
    begin_group(&all, NULL);
    for (int number = 1; row->name || row->help; row++, number++) {
        if (row->name)
            add_row(&all, row, number);
        else
            begin_group(&all, row->help);
    }
    add_row(&all, &cli_help, HELP);
    reader = poptGetContext(command->name, count, named, all.groups,
                            command->words_follow ? POPT_CONTEXT_POSIXMEHARDER : 0);
    return reader;
}

static void print_help(const cli_command *command, poptContext words, FILE *out)
{
    char usage[2048];
    const char *end = command->options->name ? "\n" : ""; /* a heading begins with one */
    snprintf(usage, sizeof usage, "%s\n\n%s%s", command->usage, command->about, end);
    poptSetOtherOptionHelp(words, usage);
    poptPrintHelp(words, out, 0);
    if (command->print_more)
        command->print_more(out);
    if (command->statuses)
        fprintf(out, "\nExit status: %s\n", command->statuses);
}

/* The words. */

static int take_option(const cli_option *row, poptContext words)
{
    const char *value = row->value ? keep(poptGetOptArg(words)) : "";
    const char *dashes = cli_dashes(row);
    if (row->value && (!value || *value == '\0'))
        return cli_wrong("a value is missing after '%s%s'", dashes, row->name);
    if (row->given)
        *row->given = row->name;
    const char *expected = row->read(row, value);
    return expected ? cli_wrong("%s%s '%s': expected %s", dashes, row->name, value, expected) : 0;
}

static int complain_of_option(int error, poptContext words)
{
    const char *word = poptBadOption(words, POPT_BADOPTION_NOALIAS);
    int length = error == POPT_ERROR_BADOPT ? (int)strlen(word) : (int)strcspn(word, "=");
    return cli_wrong("%s '%.*s'",
                     error == POPT_ERROR_BADOPT        ? "unknown option"
                     : error == POPT_ERROR_NOARG       ? "a value is missing after"
                     : error == POPT_ERROR_UNWANTEDARG ? "a value was given to"
                                                       : poptStrerror(error),
                     length, word);
}

static int take_operands(poptContext words)
{
    const char *missing = cli_running->operands ? cli_running->operands : "";
    cli_operands = poptGetArgs(words);
    for (; cli_operands && cli_operands[cli_operand_count]; cli_operand_count++) {
        if (cli_operand_count == cli_running->most_operands)
            return cli_wrong("one word too many: '%s'", cli_operands[cli_operand_count]);
        missing += strcspn(missing, " ");
        missing += *missing == ' ';
    }
    return *missing != '\0' ? cli_wrong("missing '%.*s'", (int)strcspn(missing, " "), missing) : 0;
}

/* 0 to go on; -1 after a help text. */
static int take_all(poptContext words)
{
    int number, status = 0;
    while (status == 0 && (number = poptGetNextOpt(words)) > 0) {
        if (number != HELP) {
            status = take_option(&cli_running->options[number - 1], words);
            continue;
        }
        print_help(cli_running, words, stdout);
        return -1;
    }
    if (status != 0)
        return status;
    return number < -1 ? complain_of_option(number, words) : take_operands(words);
}

/* As who writes into a pipe that nobody reads any more, whoever has ignored that meanwhile. */
static void die_of_pipe(void)
{
    signal(SIGPIPE, SIG_DFL);
    raise(SIGPIPE);
}

/* Flushes standard output. What failed for the words' sake has printed nothing. */
static int finish(int status)
{
    if (status == EXIT_USAGE || (fflush(stdout) == 0 && !ferror(stdout)))
        return status;
    const char *reason = stream_reason(stdout);
    if (errno == EPIPE)
        die_of_pipe();
    fprintf(stderr, "%s: error: standard output cannot be written: %s\n", cli_running->name,
            reason);
    return cli_running->lost ? cli_running->lost : EXIT_OUTPUT;
}

/* Threads and children have what this one may take. */
static int run_on_stack(const cli_command *command)
{
    struct rlimit stack;
    if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= STACK_LEAST)
        return command->run();
    fprintf(stderr, "%s: error: the stack may take %ju KB ('ulimit -s'); expected %d or more\n",
            command->name, (uintmax_t)stack.rlim_cur / 1024, STACK_LEAST / 1024);
    return EXIT_USAGE;
}

int cli_run(const cli_command *command, int count, char **words)
{
    signal(SIGCHLD, SIG_DFL); /* who ignores its children's end is not told of it */
    cli_running = command;
    cli_words = words + 1;
    cli_operand_count = 0;
    poptContext reader = reader_of(command, count, words);
    if (!command->run) {
        print_help(command, reader, stderr);
        return EXIT_USAGE;
    }
    int status = take_all(reader);
    if (status == 0)
        status = run_on_stack(command);
    return finish(status > 0 ? status : 0);
}

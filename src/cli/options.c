#include "options.h"

#include <errno.h>
#include <limits.h>
#include <popt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ROWS_MOST 64
#define GROUPS_MOST 8

/* Complaints. */

int cli_wrong(const cli_command *command, const char *what, const char *word)
{
    fprintf(stderr, "%s: error: %s '%s'; see '%s --help'\n", command->name, what, word,
            command->name);
    return EXIT_USAGE;
}

int cli_clash(const cli_command *command, const char *option, const char *other, const char *why)
{
    fprintf(stderr, "%s: error: %s does not go with %s: %s; see '%s --help'\n", command->name,
            option, other, why, command->name);
    return EXIT_USAGE;
}

static const char *dashes(const char *name)
{
    return name[1] == '\0' ? "-" : "--";
}

int cli_wrong_value(const cli_command *command, const char *option, const char *value,
                    const char *expected)
{
    fprintf(stderr, "%s: error: %s%s '%s': expected %s; see '%s --help'\n", command->name,
            dashes(option), option, value, expected, command->name);
    return EXIT_USAGE;
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

static void add_row(tables *all, const cli_option *row, int number)
{
    bool is_short = row->name[1] == '\0';
    all->rows[all->row_count++] =
        (struct poptOption){.longName = is_short ? NULL : row->name,
                            .shortName = is_short ? row->name[0] : '\0',
                            .argInfo = row->value ? POPT_ARG_STRING : POPT_ARG_NONE,
                            .val = number,
                            .descrip = row->help ? row->help : row->read(row, ""),
                            .argDescrip = row->value};
}

/* popt's reader of the words, in which the command is called by its name. */
static poptContext reader_of(const cli_command *command, int count, char **words)
{
    static const cli_option help = {.name = "help", .help = "print this text"};
    static tables all; /* lives as long as the reader, that is as the program */
    static poptContext reader;
    const char **named = (const char **)words;
    const cli_option *row = command->options;
    named[0] = command->name;
    begin_group(&all, NULL);
    for (int number = 1; row->name || row->help; row++, number++) {
        if (row->name)
            add_row(&all, row, number);
        else
            begin_group(&all, row->help);
    }
    add_row(&all, &help, HELP);
    reader = poptGetContext(command->name, count, named, all.groups, 0);
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

/* A value is popt's copy of it. */
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

static int take_option(const cli_command *command, const cli_option *row, poptContext words)
{
    const char *value = row->value ? keep(poptGetOptArg(words)) : "";
    char word[64];
    snprintf(word, sizeof word, "%s%s", dashes(row->name), row->name);
    if (row->value && (!value || *value == '\0'))
        return cli_wrong(command, "a value is missing after", word);
    if (row->given)
        *row->given = row->name;
    const char *expected = row->read(row, value);
    return expected ? cli_wrong_value(command, row->name, value, expected) : 0;
}

static int complain_of_option(const cli_command *command, int error, poptContext words)
{
    char word[256];
    snprintf(word, sizeof word, "%s", poptBadOption(words, POPT_BADOPTION_NOALIAS));
    if (error == POPT_ERROR_BADOPT)
        return cli_wrong(command, "unknown option", word);
    word[strcspn(word, "=")] = '\0';
    if (error == POPT_ERROR_NOARG)
        return cli_wrong(command, "a value is missing after", word);
    if (error == POPT_ERROR_UNWANTEDARG)
        return cli_wrong(command, "a value was given to", word);
    return cli_wrong(command, poptStrerror(error), word);
}

static int complain_of_missing(const cli_command *command, int taken)
{
    char name[32];
    const char *at = command->operands.names;
    for (; taken > 0; taken--)
        at += strcspn(at, " ") + 1;
    snprintf(name, sizeof name, "%.*s", (int)strcspn(at, " "), at);
    return cli_wrong(command, "missing", name);
}

static int take_operands(const cli_command *command, poptContext words)
{
    const cli_operands *wanted = &command->operands;
    const char **taken = poptGetArgs(words);
    int count = 0, named = wanted->names ? 1 : 0;
    for (const char *at = wanted->names; at && (at = strchr(at, ' ')); at++)
        named++;
    while (taken && taken[count] && count < wanted->most)
        count++;
    if (taken && taken[count])
        return cli_wrong(command, "one word too many:", taken[count]);
    if (count < named)
        return complain_of_missing(command, count);
    if (wanted->to)
        *wanted->to = taken;
    if (wanted->count)
        *wanted->count = count;
    return 0;
}

/* 0 to go on; -1 after a help text. */
static int take_all(const cli_command *command, poptContext words)
{
    int number;
    while ((number = poptGetNextOpt(words)) > 0) {
        if (number == HELP) {
            print_help(command, words, stdout);
            return -1;
        }
        int status = take_option(command, &command->options[number - 1], words);
        if (status != 0)
            return status;
    }
    return number < -1 ? complain_of_option(command, number, words) : take_operands(command, words);
}

/* Flushes standard output. What failed for the words' sake has printed nothing. */
static int finish(const cli_command *command, int status)
{
    errno = 0; /* the reason of an earlier failure is not known any more */
    if (status == EXIT_USAGE || (fflush(stdout) == 0 && !ferror(stdout)))
        return status;
    fprintf(stderr, "%s: error: standard output cannot be written%s%s\n", command->name,
            errno != 0 ? ": " : "", errno != 0 ? strerror(errno) : "");
    return command->lost ? command->lost : EXIT_OUTPUT;
}

char *const *cli_words;

int cli_run(const cli_command *command, int count, char **words)
{
    cli_words = words + 1;
    if (command->begin)
        command->begin();
    poptContext reader = reader_of(command, count, words);
    if (!command->run) {
        print_help(command, reader, stderr);
        return EXIT_USAGE;
    }
    int status = take_all(command, reader);
    if (status == 0)
        status = command->run();
    return finish(command, status > 0 ? status : 0);
}

/* SPDX-License-Identifier: MIT */
/* A subcommand's words. It has one table of options, which says how each is written, what its help
 * text is and where its value goes; popt reads the words and lays the help text out. A complaint is
 * one line on standard error that names the command. */
#pragma once

#include "../cases/regimes.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* Exit statuses beside EXIT_SUCCESS. */
#define EXIT_OUTPUT 1  /* the output could not be written */
#define EXIT_USAGE 2   /* the command line or what it names to be read is wrong */
#define EXIT_TROUBLE 2 /* all of that, of programs that compare: 1 is for what differs */

#define CLI_DIGITS(number) #number
#define CLI_NUMERAL(number) CLI_DIGITS(number) /* "1000" of a macro, for a help text */

typedef struct cli_option cli_option;

/* Takes the value over: returns NULL, or what was expected instead, as of "". The value lives as
 * long as the program. */
typedef const char *cli_reader(const cli_option *row, const char *value);

/* A table ends with {0}. */
struct cli_option {
    const char *name;  /* "size" of --size, "o" of -o; NULL: `help` is a heading */
    const char *value; /* how the help text calls it; NULL: the option has none */
    const char *help;  /* NULL: what its reader expects */
    cli_reader *read;
    void *to;
    uint64_t least, most;     /* of a number */
    const char *const *words; /* that the value may be; NULL ends them */
    const char **given;       /* where the option's name goes if it is given, or NULL */
};

typedef struct {
    const char *name;          /* "surehit render" */
    const char *summary;       /* in the list of commands */
    const char *usage, *about; /* words behind the name, and what the command does */
    const cli_option *options;
    const char *operands; /* "CERTIFICATE SCENE.rt": what each of them is called that is missing */
    int most_operands;
    bool words_follow;             /* the first operand ends its options: they are another's */
    const char *cut_output;        /* "-o": its result where it works in pieces; NULL: it doesn't */
    void (*print_more)(FILE *out); /* a part of the help text behind the options, or NULL */
    const char *statuses;          /* the last part of it */
    int lost;                      /* exit status where standard output is lost; 0: EXIT_OUTPUT */
    int (*run)(void);              /* the exit status; NULL: the help text is a complaint */
} cli_command;

/* Reads the words, behind the first, and runs the command. Returns its exit status, or
 * command->lost after a complaint if any of standard output was lost. */
int cli_run(const cli_command *command, int count, char **words);

/* It; its words as they were given, NULL ends them; those that are no options. */
extern const cli_command *cli_running;
extern char *const *cli_words;
extern const char **cli_operands;
extern int cli_operand_count;

/* --help, which every command has; "-" of -o, "--" of --size; and a row's help text. */
extern const cli_option cli_help;
const char *cli_dashes(const cli_option *row);
const char *cli_help_of(const cli_option *row);

/* Complains of the words: one line, and EXIT_USAGE. */
__attribute__((format(printf, 1, 2))) int cli_wrong(const char *format, ...);

/* 0 where files can be written to these paths, of which some may be NULL; else a status after a
 * complaint. None may take the place of an input, nor of another output, nor be "-". */
typedef struct {
    const char *const *outputs, *const *inputs;
    int output_count, input_count;
} cli_paths;
int cli_paths_check(const cli_paths *all);

/* Readers. What `to` points to is said behind each. */
cli_reader cli_flag;          /* bool: true */
cli_reader cli_text;          /* const char * */
cli_reader cli_texts;         /* cli_list: one more */
cli_reader cli_number;        /* uint64_t, a whole number in [least, most] */
cli_reader cli_int;           /* int, likewise */
cli_reader cli_seconds;       /* double */
cli_reader cli_word;          /* int or an enum, the index of one of `words` */
cli_reader cli_mark;          /* bools, true at the index of one of `words` */
cli_reader cli_tier;          /* sure_tier */
cli_reader cli_fallible_tier; /* the same, one that can be wrong */
cli_reader cli_drawn_tier;    /* the same, of a picture */
cli_reader cli_shape;         /* regime_rows */
cli_reader cli_regime;        /* regime_rows */
cli_reader cli_set;           /* regime_rows */
cli_reader cli_entry;         /* const char *, words of an entry, one at least */
cli_reader cli_scene;         /* render_settings, the option of that name */

/* What an option that may be repeated was given. */
#define CLI_LIST_MOST 16
typedef struct {
    const char *texts[CLI_LIST_MOST];
    int count;
} cli_list;

/* 0 if there is a regime that one of the shapes has; else EXIT_USAGE after a complaint. */
int cli_rows_check(const regime_rows *asked);

/* A set that is asked for says how many cases there are, and their seed. 0, or EXIT_USAGE after a
 * complaint where an option, `numbered`, has said others. */
int cli_rows_numbers(const regime_rows *asked, const char *numbered, uint64_t *count,
                     uint64_t *seed);

/* Rows that several tables have. */
/* clang-format off */
#define CLI_THREADS(threads) \
    {"threads", "N", "1 to 1024 (default: one a core); the result stays the same", cli_int, \
     .to = threads, .least = 1, .most = 1024}
#define CLI_SIZE(settings) \
    {"size", "WxH", "pixels (default 1280x720, or the scene's R line)", cli_scene, .to = settings}
#define CLI_INSTRUCTIONS(told) \
    {"instructions", NULL, \
     "count instructions a ray, too, which repeat: by valgrind, of the first 512 cases of a row", \
     cli_flag, .to = told}
#define CLI_SET(rows) \
    {"set", "NAME", \
     "the cases of a frozen set, the same for ever: these say which count, which seed", \
     cli_set, .to = rows}
#define CLI_DRAWN_TIER(tier) \
    {"tier", "TIER", NULL, cli_drawn_tier, .to = tier}
#define CLI_MEANINGS(settings) \
    {NULL, .help = "How the scene is meant, default first; these win over its own `#!` lines:"}, \
    {"handedness", "HAND", "right or left", cli_scene, .to = settings}, \
    {"fov", "AXIS", "horizontal or vertical", cli_scene, .to = settings}, \
    {"cylinder-position", "AT", "middle or base", cli_scene, .to = settings}, \
    {"cone-position", "AT", "middle, apex or base", cli_scene, .to = settings}, \
    {"falloff", "KIND", "none or inverse-square", cli_scene, .to = settings}, \
    {"skip-unknown", NULL, "leave out unknown surfaces", cli_scene, .to = settings}, \
    {"dialect", "NAME", "strict; or 42, scenes of that exercise as they are found", cli_scene, \
     .to = settings}, \
    {"camera", "N", "of several, in dialect 42 (default: the first)", cli_scene, .to = settings}
/* clang-format on */

/* print_more: the regimes' names. And those of the sets, too. */
void cli_print_regimes(FILE *out);
void cli_print_sets(FILE *out);

/* What is run without a subcommand; those that it lists, up to NULL; and one by its word, listed or
 * not, or NULL. */
extern const cli_command cli_program, *const cli_commands[];
const cli_command *cli_command_of(const char *word);
const char *cli_word_of(const cli_command *command); /* "check" of "surehit check" */

/* The subcommands. */
extern const cli_command command_render, command_merge, command_check, command_diff,
    command_regress, command_cases, command_answer, command_judge, command_report, command_shrink,
    command_vectors, command_walk, command_bench, command_plan, command_work, command_status,
    command_describe;

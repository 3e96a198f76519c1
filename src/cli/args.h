/* The words of a command line, one after the other. "--opt value" and "--opt=value" are the same,
 * "--" ends the options, and a complaint is one line on standard error that names the command. */
#ifndef CLI_ARGS_H
#define CLI_ARGS_H

#include <stdbool.h>
#include <stdint.h>

/* Exit statuses beside EXIT_SUCCESS. */
#define EXIT_OUTPUT 1 /* the output could not be written */
#define EXIT_USAGE 2  /* the command line or what it names to be read is wrong */

typedef struct {
    const char *command; /* "surehit render" */
    char **words;
    int count, next;
    bool options_ended;
} args;

typedef struct {
    const char *name; /* "--size" */
    bool has_value;
} args_option;

/* What args_next returns for anything but an option. */
enum { ARGS_END = -1, ARGS_OPERAND = -2, ARGS_WRONG = -3 };

/* The index of the next option, its value (NULL for none) in *value; ARGS_OPERAND, the word in
 * *value; ARGS_END; or ARGS_WRONG after a complaint (an unknown option, a value that is missing or
 * too much). */
int args_next(args *line, const args_option *options, int option_count, const char **value);

/* Complaints about a word, and about an option's value. Both return EXIT_USAGE. */
int args_wrong(const args *line, const char *what, const char *word);
int args_wrong_value(const args *line, const char *option, const char *value, const char *expected);

/* Reads digits and nothing else: true and *number if it is in [least, most]. */
bool args_number(const char *text, uint64_t least, uint64_t most, uint64_t *number);

/* Flushes standard output: `status`, or EXIT_OUTPUT after a complaint if any of it was lost. */
int args_flush_output(const args *line, int status);

#endif

/* SPDX-License-Identifier: MIT */
#include "words.h"

#include <made.h> /* by the build */
#include <stdlib.h>
#include <string.h>

json_t *words_asked(json_t *words)
{
    return json_pack("{s:i, s:o, s:s, s:s, s:s, s:s}", "surehit pieces", 1, "words", words,
                     "sources", MADE_SOURCES, "compiler", MADE_COMPILER, "flags", MADE_FLAGS,
                     "architecture", MADE_ARCHITECTURE);
}

const cli_command *words_command(const json_t *asked)
{
    const json_t *words = json_object_get(asked, "words"), *one;
    const char *word = json_string_value(json_array_get(words, 0));
    const cli_command *command = word ? cli_command_of(word) : NULL;
    size_t i;
    bool texts = true;
    json_array_foreach(words, i, one) texts = texts && json_is_string(one);
    if (command && command->cut_output && texts)
        return command;
    cli_wrong("nothing that is worked off in pieces: '%s'", word ? word : "");
    return NULL;
}

/* A word more, that lives as long as the program. */
static void append(char **words, int *count, const char *word)
{
    words[*count] = strdup(word);
    if (!words[(*count)++])
        abort();
}

int words_run(const json_t *asked, const more_words *more)
{
    const cli_command *command = words_command(asked);
    const json_t *words = json_object_get(asked, "words"), *word;
    size_t i;
    int count = 0;
    if (!command)
        return EXIT_USAGE;
    char **all = calloc(json_array_size(words) + 2 * MORE_WORDS_MOST + 1, sizeof *all);
    if (!all)
        abort();
    json_array_foreach(words, i, word) append(all, &count, json_string_value(word));
    for (; more->name; more++) {
        if (more->value)
            append(all, &count, more->name);
        if (more->value && *more->value != '\0')
            append(all, &count, more->value);
    }
    return cli_run(command, count, all);
}

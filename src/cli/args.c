#include "args.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int complain(const args *line, const char *what, const char *word)
{
    args_wrong(line, what, word);
    return ARGS_WRONG;
}

/* Is `word` this option? *attached is what follows the "=" of a long one, or NULL. */
static bool is_option(const char *word, const char *name, const char **attached)
{
    size_t length = strlen(name);
    if (strncmp(word, name, length) != 0)
        return false;
    bool may_attach = name[1] == '-';
    *attached = may_attach && word[length] == '=' ? word + length + 1 : NULL;
    return *attached || word[length] == '\0';
}

int args_next(args *line, const args_option *options, int option_count, const char **value)
{
    if (line->next == line->count)
        return ARGS_END;
    const char *word = line->words[line->next++];
    if (!line->options_ended && strcmp(word, "--") == 0) {
        line->options_ended = true;
        return args_next(line, options, option_count, value);
    }
    if (line->options_ended || word[0] != '-' || word[1] == '\0') {
        *value = word;
        return ARGS_OPERAND;
    }
    int found = 0;
    while (found < option_count && !is_option(word, options[found].name, value))
        found++;
    if (found == option_count)
        return complain(line, "unknown option", word);
    if (!options[found].has_value)
        return *value ? complain(line, "a value was given to", options[found].name) : found;
    if (!*value && line->next < line->count)
        *value = line->words[line->next++];
    if (!*value || **value == '\0')
        return complain(line, "a value is missing after", options[found].name);
    return found;
}

int args_wrong(const args *line, const char *what, const char *word)
{
    fprintf(stderr, "%s: error: %s '%s'; see '%s --help'\n", line->command, what, word,
            line->command);
    return EXIT_USAGE;
}

int args_wrong_value(const args *line, const char *option, const char *value, const char *expected)
{
    fprintf(stderr, "%s: error: %s '%s': expected %s; see '%s --help'\n", line->command, option,
            value, expected, line->command);
    return EXIT_USAGE;
}

bool args_number(const char *text, uint64_t least, uint64_t most, uint64_t *number)
{
    if (*text == '\0' || text[strspn(text, "0123456789")] != '\0')
        return false;
    errno = 0;
    uintmax_t read = strtoumax(text, NULL, 10);
    if (errno != 0 || read < least || read > most)
        return false;
    *number = read;
    return true;
}

int args_flush_output(const args *line, int status)
{
    errno = 0; /* the reason of an earlier failure is not known any more */
    if (fflush(stdout) == 0 && !ferror(stdout))
        return status;
    fprintf(stderr, "%s: error: standard output cannot be written%s%s\n", line->command,
            errno != 0 ? ": " : "", errno != 0 ? strerror(errno) : "");
    return EXIT_OUTPUT;
}

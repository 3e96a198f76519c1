/* SPDX-License-Identifier: MIT */
/* Commands that a user can paste. */
#pragma once

#include "printable.h"

#include <ctype.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Is the byte a control character, or one of the two that UTF-8 has for those of Unicode? */
static inline bool shell_is_obeyed(const char *at, const char *first)
{
    const unsigned char *byte = (const unsigned char *)at;
    return iscntrl(byte[0]) || printable_is_pair(byte) ||
           (at > first && printable_is_pair(byte - 1));
}

/* The word, in quotes where a shell would not read it as it stands. What a terminal would obey is
 * left to the shell's printf. */
static inline void shell_print(FILE *out, const char *word)
{
    bool plain = *word != '\0' && !strpbrk(word, " '\"\\$`&;<>()|*?[]#~!{}");
    for (const char *at = word; *at != '\0'; at++)
        plain &= !shell_is_obeyed(at, word);
    if (plain) {
        fputs(word, out);
        return;
    }
    const char *const first = word;
    fputc('\'', out);
    for (; *word != '\0'; word++) {
        if (*word == '\'')
            fputs("'\\''", out);
        else if (shell_is_obeyed(word, first) && *word != '\t' && *word != '\n')
            fprintf(out, "'\"$(printf '\\%03o')\"'", (unsigned char)*word);
        else
            fputc(*word, out);
    }
    fputc('\'', out);
}

/* This program as it was called, which finds it again from the same folder. */
static inline void shell_print_program(FILE *out)
{
    shell_print(out, program_invocation_name);
}

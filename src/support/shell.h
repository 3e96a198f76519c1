/* SPDX-License-Identifier: MIT */
/* Commands that a user can paste. */
#pragma once

#include <ctype.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* The word, in quotes where a shell would not read it as it stands. What a terminal would obey is
 * left to the shell's printf. */
static inline void shell_print(FILE *out, const char *word)
{
    bool plain = *word != '\0' && !strpbrk(word, " '\"\\$`&;<>()|*?[]#~!{}");
    for (const char *at = word; *at != '\0'; at++)
        plain &= !iscntrl((unsigned char)*at);
    if (plain) {
        fputs(word, out);
        return;
    }
    fputc('\'', out);
    for (; *word != '\0'; word++) {
        if (*word == '\'')
            fputs("'\\''", out);
        else if (iscntrl((unsigned char)*word) && *word != '\t' && *word != '\n')
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

/* SPDX-License-Identifier: MIT */
#include "shell.h"

#include <errno.h>
#include <string.h>

void shell_print(FILE *out, const char *word)
{
    if (*word != '\0' && !strpbrk(word, " \t\n'\"\\$`&;<>()|*?[]#~!{}")) {
        fputs(word, out);
        return;
    }
    fputc('\'', out);
    for (; *word != '\0'; word++) {
        if (*word == '\'')
            fputs("'\\''", out);
        else
            fputc(*word, out);
    }
    fputc('\'', out);
}

void shell_print_program(FILE *out)
{
    shell_print(out, program_invocation_name);
}

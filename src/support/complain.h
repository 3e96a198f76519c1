/* SPDX-License-Identifier: MIT */
/* What is wrong with a file, in one line. */
#pragma once

#include "printable.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

/* "PATH: error: ..."; returns false. */
__attribute__((format(printf, 3, 4))) static inline bool complain(FILE *messages, const char *path,
                                                                  const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    printable_print(messages, path);
    fputs(": error: ", messages);
    printable_vprint(messages, format, arguments);
    fputc('\n', messages);
    va_end(arguments);
    return false;
}

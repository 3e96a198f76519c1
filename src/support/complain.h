/* SPDX-License-Identifier: MIT */
/* What is wrong with a file, in one line. */
#pragma once

#include "printable.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

static inline void complain_so(FILE *messages, const char *path, const char *how,
                               const char *format, va_list arguments)
{
    printable_print(messages, path);
    fputs(how, messages);
    printable_vprint(messages, format, arguments);
    fputc('\n', messages);
}

/* "PATH: error: ..."; returns false. */
__attribute__((format(printf, 3, 4))) static inline bool complain(FILE *messages, const char *path,
                                                                  const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    complain_so(messages, path, ": error: ", format, arguments);
    va_end(arguments);
    return false;
}

/* "PATH: warning: ..." */
__attribute__((format(printf, 3, 4))) static inline void warn(FILE *messages, const char *path,
                                                              const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    complain_so(messages, path, ": warning: ", format, arguments);
    va_end(arguments);
}

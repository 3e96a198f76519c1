/* SPDX-License-Identifier: MIT */
/* Text of others for a terminal, which obeys none of it: control characters are shown, ESC as \x1b.
 */
#pragma once

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

/* Writes 1 or 4 letters: its end. Nothing above `most` is shown as it is. */
static inline char *printable_byte(char *to, unsigned char byte, unsigned char most)
{
    if (byte < ' ' || byte == 0x7f || byte > most)
        return to + sprintf(to, "\\x%02x", byte);
    *to = (char)byte;
    return to + 1;
}

/* As much of the text as fits into `size` >= 5 bytes. */
static inline void printable_write(char *to, size_t size, const char *text)
{
    const char *last = to + size - 5;
    for (; *text != '\0' && to <= last; text++)
        to = printable_byte(to, (unsigned char)*text, 0xff);
    *to = '\0';
}

static inline void printable_print(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        char shown[5];
        *printable_byte(shown, (unsigned char)*text, 0xff) = '\0';
        fputs(shown, out);
    }
}

/* Where there is no memory, the format alone. */
__attribute__((format(printf, 2, 0))) static inline void
printable_vprint(FILE *out, const char *format, va_list values)
{
    char *text;
    bool made = vasprintf(&text, format, values) >= 0;
    printable_print(out, made ? text : format);
    if (made)
        free(text);
}

__attribute__((format(printf, 2, 3))) static inline void printable_printf(FILE *out,
                                                                          const char *format, ...)
{
    va_list values;
    va_start(values, format);
    printable_vprint(out, format, values);
    va_end(values);
}

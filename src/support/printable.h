/* SPDX-License-Identifier: MIT */
/* Text of others for a terminal, which obeys none of it: control characters are shown, ESC as \x1b,
 * those of Unicode that UTF-8 has in two bytes, too, CSI as \xc2\x9b. */
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

/* A control character of Unicode, as UTF-8 has it. */
static inline bool printable_is_pair(const unsigned char *byte)
{
    return byte[0] == 0xc2 && (byte[1] & 0xe0) == 0x80;
}

/* The letters of the text's next byte, or of the two of a control character: their end. */
static inline char *printable_next(char *to, const char **text)
{
    const unsigned char *byte = (const unsigned char *)*text;
    const bool is_pair = printable_is_pair(byte);
    for (int i = 0; i <= is_pair; i++)
        to = printable_byte(to, byte[i], is_pair ? 0x7f : 0xff);
    *text += 1 + is_pair;
    return to;
}

enum { PRINTABLE_MOST = 8 };

/* As much of the text as fits into `size` > PRINTABLE_MOST bytes. */
static inline void printable_write(char *to, size_t size, const char *text)
{
    const char *last = to + size - 1 - PRINTABLE_MOST;
    while (*text != '\0' && to <= last)
        to = printable_next(to, &text);
    *to = '\0';
}

static inline void printable_print(FILE *out, const char *text)
{
    while (*text != '\0') {
        char shown[PRINTABLE_MOST + 1];
        *printable_next(shown, &text) = '\0';
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

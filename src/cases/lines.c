/* SPDX-License-Identifier: MIT */
#include "lines.h"

#include <errno.h>
#include <string.h>

#define LENGTH_MOST (1 << 20) /* that of no line of text */

bool case_lines_next(case_lines *lines)
{
    int c = getc_unlocked(lines->in);
    size_t kept = 0;
    if (c == EOF)
        return false;
    lines->number++;
    for (lines->length = 0; c != '\n' && c != EOF; c = getc_unlocked(lines->in)) {
        if (++lines->length > LENGTH_MOST)
            return false;
        if (kept + 1 < CASE_LINES_TEXT)
            lines->text[kept++] = (char)c;
    }
    lines->text[kept] = '\0';
    lines->whole = strlen(lines->text) == lines->length;
    return c == '\n' || !ferror(lines->in);
}

const char *case_lines_fault(const case_lines *lines)
{
    if (ferror(lines->in))
        return strerror(errno);
    return lines->length > LENGTH_MOST ? "no end of a line" : NULL;
}

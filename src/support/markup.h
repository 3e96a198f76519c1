/* SPDX-License-Identifier: MIT */
/* Text in HTML and XML, also between quotes. What XML has no way to say is a question mark. */
#pragma once

#include <stdio.h>

static inline void markup_print(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        unsigned char letter = (unsigned char)*text;
        switch (letter) {
        case '&': fputs("&amp;", out); break;
        case '<': fputs("&lt;", out); break;
        case '>': fputs("&gt;", out); break;
        case '"': fputs("&quot;", out); break;
        case '\'': fputs("&#39;", out); break;
        case '\n': fputs("&#10;", out); break;
        case '\t': fputs("&#9;", out); break;
        default: fputc(letter < ' ' ? '?' : letter, out);
        }
    }
}

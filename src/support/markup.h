/* SPDX-License-Identifier: MIT */
/* Text in HTML and XML, also between quotes. What XML has no way to say is a question mark. */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Names and what programs write may be any bytes. Where they are no UTF-8, those that are no ASCII
 * are shown as question marks. */
static inline bool is_utf8(const char *text)
{
    json_t *made = json_string(text);
    json_decref(made);
    return made != NULL;
}

static inline void markup_print(FILE *out, const char *text)
{
    const unsigned char most = is_utf8(text) ? 0xff : 0x7f;
    for (; *text != '\0'; text++) {
        unsigned char letter = (unsigned char)*text;
        if (strncmp(text, "\xef\xbf\xbe", 3) == 0 || strncmp(text, "\xef\xbf\xbf", 3) == 0) {
            fputc('?', out); /* U+FFFE, U+FFFF */
            text += 2;
            continue;
        }
        switch (letter) {
        case '&': fputs("&amp;", out); break;
        case '<': fputs("&lt;", out); break;
        case '>': fputs("&gt;", out); break;
        case '"': fputs("&quot;", out); break;
        case '\'': fputs("&#39;", out); break;
        case '\n': fputs("&#10;", out); break;
        case '\t': fputs("&#9;", out); break;
        default: fputc(letter < ' ' || letter > most ? '?' : letter, out);
        }
    }
}

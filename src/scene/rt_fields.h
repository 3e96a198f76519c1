/* The fields of a scene's line: words, numbers, vectors and colours.
 *
 * Each rt_read_... reads what is next and moves behind it. A fault in it is noted with its place;
 * false when the rest of the line makes no sense after that. A number at fault becomes NaN, which
 * passes every later check: no fault is named twice. */
#ifndef SCENE_RT_FIELDS_H
#define SCENE_RT_FIELDS_H

#include "rt_notes.h"

#include <locale.h> /* locale_t, in POSIX */
#include <string.h>

#define RT_LONGEST_LINE 65535 /* bytes: longer ones are not for these functions */
#define RT_WHOLE_MAX 65535

/* A line while it is read. */
typedef struct {
    rt_notes *notes;
    const char *at, *end; /* what is read next, and the end of the line */
    locale_t c_locale;    /* a number has a point, never a comma */
} rt_line;

/* The three inline ones would, as calls, take a seventh of the time of a large scene. */

static inline bool rt_is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static inline void rt_skip_blanks(rt_line *line)
{
    while (line->at < line->end && rt_is_blank(*line->at))
        line->at++;
}

/* Is there more before the end of the line or a comment? Skips blanks. */
bool rt_more_fields(rt_line *line);

/* What stands between `start` and the next blank, comma, comment or end of the line ... */
rt_word rt_word_at(const rt_line *line, const char *start);

/* ... and the same with commas as a part of it. */
rt_word rt_run_at(const rt_line *line, const char *start);

static inline bool rt_is_word(rt_word word, const char *text)
{
    for (; word.start < word.end; word.start++, text++) {
        if (*word.start != *text)
            return false;
    }
    return *text == '\0';
}

/* A digit, a sign or a point. */
bool rt_starts_number(char c);

/* A number that stands just here, ... */
bool rt_read_value(rt_line *line, const rt_field *field, double *value);
bool rt_read_integer(rt_line *line, const rt_field *field, int *value);

/* ... and what blanks may stand before: */
bool rt_read_scalar(rt_line *line, const rt_field *field, double *value);
bool rt_read_vector(rt_line *line, const rt_field *field, sure_vec3 *vector);
bool rt_read_direction(rt_line *line, const rt_field *field, sure_vec3 *vector); /* not zero */
bool rt_read_color(rt_line *line, sure_vec3 *linear); /* 0..1, from 0..255 */

/* Notes what still stands on the line, if anything does. */
void rt_expect_end(rt_line *line);

#endif

/* A scene while it is read: line by line, field by field.
 *
 * Each rt_read_... reads what is next and moves behind it. A fault in it is noted with its place;
 * false when the rest of the line makes no sense after that. A number at fault becomes NaN, which
 * passes every later check: no fault is named twice. */
#pragma once

#include "shapes/rt_shape.h"

#include <locale.h> /* locale_t, in POSIX */
#include <string.h>

#define RT_LONGEST_LINE 65535 /* bytes: longer ones are not for these functions */
#define RT_WHOLE_MAX 65535

typedef struct {
    const char *at, *end; /* what is read next, and the end of the line */
    locale_t c_locale;    /* a number has a point, never a comma */
    rt_notes notes;
    const rt_options *options; /* of the command line */
    rt_options_set set;
    bool out_of_memory;

    rt_scene scene;
    rt_options_set set_by_scene;
    rt_place ambient_at; /* nowhere: none seen */
    bool has_light;
} rt_reader;

/* Notes an error at a place of the line. */
#define rt_fault(r, place, ...)                                                                    \
    rt_complain(&(r)->notes, RT_ERROR, rt_place_of(&(r)->notes, place), __VA_ARGS__)

/* The three inline ones would, as calls, take a seventh of the time of a large scene. */

static inline bool rt_is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static inline void rt_skip_blanks(rt_reader *r)
{
    while (r->at < r->end && rt_is_blank(*r->at))
        r->at++;
}

/* Is there more before the end of the line or a comment? Skips blanks. */
bool rt_more_fields(rt_reader *r);

/* What stands between `start` and the next blank, comma, comment or end of the line ... */
rt_word rt_word_at(const rt_reader *r, const char *start);

/* ... and the same with commas as a part of it. */
rt_word rt_run_at(const rt_reader *r, const char *start);

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

/* The field that stands just here, into its place of what the line describes. */
bool rt_read_field(rt_reader *r, const rt_field *field, void *of);

/* All of them, up to one without a name; blanks may stand before each. */
bool rt_read_fields(rt_reader *r, const rt_field *fields, void *of);

/* Notes what still stands on the line, if anything does. */
void rt_expect_end(rt_reader *r);

/* The lines of a scene that are parts of it: each reads the fields behind its line's first word. */
void rt_read_ambient(rt_reader *r, rt_word identifier);
void rt_read_camera(rt_reader *r, rt_word identifier);
void rt_read_light(rt_reader *r, rt_word identifier);
void rt_read_shape(rt_reader *r, rt_word identifier, sure_shape shape);

/* SPDX-License-Identifier: MIT */
/* A scene while it is read: line by line, field by field.
 *
 * Each rt_read_... reads what is next and moves behind it. A fault in it is noted with its place;
 * false when the rest of the line makes no sense after that. A number at fault becomes NaN, which
 * passes every later check: no fault is named twice. */
#pragma once

#include "shapes/rt_shape.h"

#include <locale.h> /* locale_t, in POSIX */
#include <string.h>
#include <strings.h>

#define RT_LONGEST_LINE 65535 /* bytes: longer ones are not for these functions */
#define RT_WHOLE_MAX 65535

typedef struct {
    const char *at, *end; /* what is read next, and the end of the line */
    locale_t c_locale;    /* a number has a point, never a comma */
    rt_notes notes;
    const rt_options *options; /* of the command line */
    rt_options_set set;
    bool out_of_memory;

    bool lenient;             /* the dialect is 42 */
    size_t last_left_out;     /* the last line of which a field was */
    int camera;               /* which one counts */
    bool decimals, underflow; /* the last vector has some; is 0 in part by rounding only */
    bool helps;               /* faults are such that dialect 42 would not find */

    rt_scene scene;
    rt_options_set set_by_scene;
    rt_place ambient_at, first_camera_at; /* nowhere: none seen */
    int camera_count;
    bool has_light, has_old_light, has_new_camera; /* `l` and `C` */
} rt_reader;

/* Notes an error at a place of the line. */
#define rt_fault(r, place, ...)                                                                    \
    rt_complain(&(r)->notes, (r)->helps ? RT_ERROR_BUT_IN_42 : RT_ERROR,                           \
                rt_place_of(&(r)->notes, place), __VA_ARGS__)

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

/* In letters of any case. */
static inline bool rt_is_word_in_any_case(rt_word word, const char *text)
{
    size_t length = (size_t)(word.end - word.start);
    return strlen(text) == length && strncasecmp(text, word.start, length) == 0;
}

/* A digit, a sign or a point. */
bool rt_starts_number(char c);

/* The field that stands just here, into its place of what the line describes. */
bool rt_read_field(rt_reader *r, const rt_field *field, void *of);

/* All of them, up to one without a name; blanks may stand before each. */
bool rt_read_fields(rt_reader *r, const rt_field *fields, void *of);

/* Notes what still stands on the line, if anything does. */
void rt_expect_end(rt_reader *r);

/* What the dialect is about (rt_dialect.c). */

/* May this stand there? In dialect 42, with a warning or, NULL, without; else it is an error that
 * names the dialect. */
__attribute__((format(printf, 4, 5))) bool rt_may(rt_reader *r, const char *place,
                                                  const char *warning, const char *error, ...);

/* Another form of the shape's line, which fits where its own does not; or NULL. */
const rt_form *rt_form_of(rt_reader *r, rt_word identifier, sure_shape shape);

/* Is it a word of such forms? */
bool rt_form_word(rt_word w, sure_shape *shape);

/* Passes over a field; the warning is of the first one of a line. */
void rt_leave_out(rt_reader *r, const char *warning);

/* The same where a word stands that is neither number nor vector. */
void rt_leave_out_name(rt_reader *r);

/* A colour; in dialect 42 from behind what is none, or nothing where there is no other. */
bool rt_read_color(rt_reader *r, const rt_field *f, void *of);

/* How many faults of fields were noted. */
size_t rt_errors(const rt_reader *r);

/* False, and nothing was noted or passed over, where it is not as it should be. */
bool rt_try_field(rt_reader *r, const rt_field *f, void *of);

/* The lines of a scene that are parts of it: each reads the fields behind its line's first word. */
void rt_read_ambient(rt_reader *r, rt_word identifier);
void rt_read_camera(rt_reader *r, rt_word identifier);
void rt_read_light(rt_reader *r, rt_word identifier);
void rt_read_shape(rt_reader *r, rt_word identifier, sure_shape shape);

/* A reading: begun, a text is read, and finished, as rt_read_text returns. Nothing is left to be
 * finished where it was not begun, for want of memory. */
bool rt_begin(rt_reader *r, const char *name, const rt_options *options, rt_options_set set,
              FILE *messages);
void rt_read_known(rt_reader *r, const char *text, size_t size);
bool rt_finish(rt_reader *r, rt_scene *scene);

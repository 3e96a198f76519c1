/* SPDX-License-Identifier: MIT */
/* What is said about a scene: errors and warnings, each with its place, kept in the order of the
 * text until the scene's options are resolved, because some are errors under some options only. */
#pragma once

#include "rt.h"

#include <stdarg.h>

/* A piece of the scene's text. */
typedef struct {
    const char *start, *end;
} rt_word;

/* A bright light is an error, or fine with falloff inverse-square, or dimmed in dialect 42. The
 * text of an unknown surface is its quoted word alone: an error, or a warning with skip-unknown.
 * What dialect 42 would read is an error that names it; what it takes the liberty of is a warning,
 * once of each wording. */
typedef enum {
    RT_ERROR,
    RT_WARNING,
    RT_BRIGHT_LIGHT,
    RT_UNKNOWN_SURFACE,
    RT_ERROR_BUT_IN_42,
    RT_LIBERTY,
    RT_VERDICTS
} rt_verdict;

typedef struct {
    rt_place at;
    rt_verdict verdict;
    size_t again; /* so often was the same liberty taken after it */
    char text[256];
} rt_note;

typedef struct {
    char *name; /* of the file, without control characters */
    FILE *messages;
    size_t line_number; /* where the reader is */
    const char *line_start;
    rt_note notes[RT_VERDICTS * RT_ERRORS_SHOWN];
    size_t note_count, counts[RT_VERDICTS];
} rt_notes;

#define RT_QUOTED_BYTES 24

typedef struct {
    char text[4 * RT_QUOTED_BYTES + sizeof "''..."];
} rt_quotation;

/* What a line may start with, in words. */
rt_quotation rt_identifiers(void);

/* The word in quotes, cut short, with no byte that a terminal could take for anything but text. */
rt_quotation rt_quote(rt_word word);

/* A copy of a file's name without control characters; NULL when there is no memory. */
char *rt_printable_name(const char *name);

/* A place on the line where the reader is. */
rt_place rt_place_of(const rt_notes *notes, const char *at);

/* Notes what is wrong there. */
__attribute__((format(printf, 4, 5))) void rt_complain(rt_notes *notes, rt_verdict verdict,
                                                       rt_place at, const char *format, ...);

/* The same for a function of its kind. */
void rt_complain_by(rt_notes *notes, rt_verdict verdict, rt_place at, const char *format,
                    va_list arguments);

/* Writes the notes, now that the options are resolved. Returns the number of errors. */
size_t rt_report(const rt_notes *notes, const rt_options *options);

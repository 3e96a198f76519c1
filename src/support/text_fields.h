/* Text that was written by us, read back a line at a time and strictly: a word, a blank, a value.
 * Each function returns false after one line to `messages`, but for text_take*, whose false says
 * that it is not there. */
#ifndef SUPPORT_TEXT_FIELDS_H
#define SUPPORT_TEXT_FIELDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct {
    FILE *file;
    const char *path;
    const char *kind; /* of file: "certificate" */
    FILE *messages;
    char *line;      /* without its end; to be freed */
    size_t capacity; /* of `line` */
    size_t number;   /* the line's; 0: none yet */
    const char *at;  /* what is read next of it */
} text_fields;

/* More of anything is not counted in a lifetime, and sums of counts don't overflow. */
#define TEXT_COUNT_MOST (UINT64_C(1) << 56)

/* "PATH:LINE: error: ...": returns false. */
__attribute__((format(printf, 2, 3))) bool text_wrong(const text_fields *r, const char *format,
                                                      ...);

bool text_next_line(text_fields *r);

/* Each of these moves behind what it reads and a blank that follows. */

bool text_takes(text_fields *r, const char *word);

/* Digits of a base, as printf writes them. */
bool text_take_number(text_fields *r, int base, uint64_t most, uint64_t *number);

/* A finite number, not negative, in the digits of %a. */
bool text_take_double(text_fields *r, double *number);

/* A line that begins with this word. */
bool text_next_field(text_fields *r, const char *name);

bool text_at_end(const text_fields *r, const char *expected);

/* Whole lines. */

bool text_read_count(text_fields *r, const char *name, uint64_t *count);
bool text_read_hash(text_fields *r, uint64_t *hash);

/* Counts, each behind its name. */
bool text_read_counts(text_fields *r, const char *field, const char *const *names, int count,
                      uint64_t *counts);

#endif

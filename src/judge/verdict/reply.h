/* SPDX-License-Identifier: MIT */
/* What a candidate answered to a case, whatever way it was asked. Part and normal are its own
 * business: what it does not say is not judged. */
#pragma once

#include "../../cases/case.h"

typedef enum {
    REPLY_ANSWERED,
    REPLY_GARBAGE, /* neither hit, miss nor invalid; a line that is no answer */
    REPLY_CRASHED, /* its process ended */
    REPLY_HUNG,    /* it took longer than it was given */
    REPLY_LOST,    /* its process ended well, but gave too few or too many lines */
    REPLY_UNASKED  /* it had crashed or hung too often in this row */
} reply_kind;

/* What a candidate is asked of a ray and an object (docs/judge.md, "Other questions"). */
typedef enum {
    QUERY_HIT,      /* where the boundary is met first */
    QUERY_OCCLUDED, /* whether it is */
    QUERY_INTERVAL, /* both ends of the chord */
    QUERY_INSIDE,   /* whether the ray's start is in the closed object */
    QUERIES
} query;

/* "hit", "occluded", ..., NULL at the end. */
extern const char *const query_names[];

/* The precision that a candidate answers in. */
typedef enum { PRECISION_DOUBLE, PRECISION_FLOAT } precision;

#define REPLY_NO_PART (-1)

typedef struct {
    reply_kind kind;
    query to;
    sure_status status;
    sure_field field; /* SURE_FIELD_NONE where it names none */
    double t;         /* of an interval the first end */
    double t_leave;   /* its other one */
    int part;         /* REPLY_NO_PART where it names none */
    bool has_normal;
    sure_vec3 normal;
    bool touched;  /* an output was written though there is no hit */
    bool changed;  /* asked again, it answered otherwise */
    bool leaked;   /* memory that it took for this case was not given back */
    int ended;     /* REPLY_CRASHED: how, as waitpid tells */
    char said[48]; /* REPLY_GARBAGE: what there was, its beginning */
} reply;

/* `miss`, `hit <t>`, `hit <t> <part>`, `hit <t> <part> <nx> <ny> <nz>`, - for a part that is not
 * named, `invalid`, `invalid <field>` or `invalid line`, with any blanks, tabs and carriage returns
 * around the words. Anything else is REPLY_GARBAGE. */
reply reply_read(const char *line);

/* Likewise of who is asked intervals: `interval <t_enter> <t_leave>` in the place of hits. */
reply reply_read_interval(const char *line);

/* The answer as a reply to that query, with a normal. */
reply reply_of(const case_answer *answer, query to);

/* Such a line, or a word for what happened. */
void reply_print(const reply *given, char line[CASE_LINE_MAX]);

/* The word for REPLY_CRASHED: of processes in reply_end.c. */
void reply_print_end(int ended, char line[CASE_LINE_MAX]);

/* The same answer, bit for bit. */
bool reply_same(const reply *a, const reply *b);

/* The same kind, not an answer, for replies first .. first + count - 1. */
void reply_fill(reply *replies, int first, int count, reply_kind kind, int ended);

/* SPDX-License-Identifier: MIT */
/* What an intersection function answers; docs/contract.md says what the right answer is. */
#pragma once

#include <surehit/linkage.h>

SURE_C_BEGIN

/* Outputs that are "untouched" keep their values, and may be read and written with them: so an
 * output is always writable, and no other thread uses it meanwhile. */
typedef enum {
    SURE_MISS,   /* no boundary point in [t_min, t_max]; outputs untouched */
    SURE_HIT,    /* outputs written */
    SURE_INVALID /* an input breaks the contract; outputs untouched; sure_*_check names the field */
} sure_status;

/* Every part once, for tables: DO(surface, SURFACE) ... Where several share a point (a rim, an
 * edge), the first of them is reported; the apex is a wall. */
#define SURE_EACH_PART(DO)                                                                         \
    DO(surface, SURFACE) DO(base, BASE) DO(top, TOP) DO(wall, WALL) DO(x_min, X_MIN)               \
        DO(x_max, X_MAX) DO(y_min, Y_MIN) DO(y_max, Y_MAX) DO(z_min, Z_MIN) DO(z_max, Z_MAX)

/* SURE_PART_SURFACE, ... */
#define SURE_PART_OF(part, PART) SURE_PART_##PART,
typedef enum { SURE_EACH_PART(SURE_PART_OF) } sure_part;

#define SURE_PARTS 10

/* Every field once, in the order in which the contract checks them. */
#define SURE_EACH_FIELD(DO)                                                                        \
    DO(none, NONE)                                                                                 \
    DO(o, O) DO(d, D) DO(t_min, T_MIN) DO(t_max, T_MAX) DO(point, POINT) DO(centre, CENTRE)        \
        DO(base, BASE) DO(normal, NORMAL) DO(top, TOP) DO(apex, APEX) DO(radius, RADIUS)           \
        DO(low, LOW) DO(high, HIGH)

/* SURE_FIELD_NONE, SURE_FIELD_O, ... */
#define SURE_FIELD_OF(field, FIELD) SURE_FIELD_##FIELD,
typedef enum { SURE_EACH_FIELD(SURE_FIELD_OF) } sure_field;

typedef struct {
    double t;       /* in multiples of the ray's direction */
    double t_error; /* |t - t*| is at most this; +infinity where the tier promises none */
    sure_part part;
    int leaves; /* 1 where the ray comes from a solid's inside and leaves it here, else 0 */
} sure_hit;

/* The ends of the chord that the ray's whole line cuts from the closed object, not clipped to
 * [t_min, t_max]; infinite where the chord is (a line in a plane). */
typedef struct {
    double t_enter, t_leave; /* t_enter <= t_leave */
    sure_part enter_part, leave_part;
} sure_interval;

/* The stages of `certain` and `exact`: each answers for certain or leaves it to the next. */
typedef enum {
    SURE_STAGE_DOUBLE,        /* double arithmetic with a proven bound */
    SURE_STAGE_DOUBLE_DOUBLE, /* twice the digits */
    SURE_STAGE_MOD128,        /* the low 128 bits of whole numbers */
    SURE_STAGE_EXACT          /* whole numbers of any length */
} sure_stage;

#define SURE_STAGES 4

/* The words of the case format (docs/contract.md): "miss", "wall", "t_max", ... ; NULL for a
 * number that is no member. SURE_FIELD_NONE is "none". */
const char *sure_status_name(sure_status status);
const char *sure_part_name(sure_part part);
const char *sure_field_name(sure_field field);

/* "double", "double-double", "mod128", "exact"; likewise. */
const char *sure_stage_name(sure_stage stage);

SURE_C_END

/* A closed convex object's chord by name: which points of the line its two ends are. Names can be
 * certain where numbers are rounded, so this is what every stage of `certain` and `exact` decides;
 * numbers come afterwards. */
#ifndef SHAPES_CHORD_H
#define SHAPES_CHORD_H

#include <surehit/ray.h>

#include <stdbool.h>

typedef enum {
    POINT_LESS,    /* the lesser root of the body's quadratic, or its only one */
    POINT_MORE,    /* the greater root */
    POINT_BASE,    /* where the line crosses the base's plane; the plane or the disc itself */
    POINT_TOP,     /* ... the plane of the top, or through the apex */
    POINT_START,   /* t_min, on a chord that is boundary as a whole */
    POINT_TOUCH,   /* both roots in one, the vertex -b/a */
    POINT_ENDLESS, /* no point: a line within a plane has no ends */
} point;

typedef struct {
    point at;
    sure_part part;
} chord_end;

typedef struct {
    bool empty;
    bool boundary;        /* the line misses the interior: all of the chord is boundary, ... */
    sure_part inner_part; /* ... and this is its part between the ends */
    chord_end enter, leave;
} chord;

static inline chord chord_empty(void)
{
    return (chord){.empty = true};
}

static inline chord chord_between(chord_end enter, chord_end leave)
{
    return (chord){.enter = enter, .leave = leave};
}

static inline chord chord_point(chord_end only)
{
    return chord_between(only, only);
}

/* A chord in the boundary. */
static inline chord chord_along(chord_end enter, chord_end leave, sure_part inner_part)
{
    return (chord){.boundary = true, .inner_part = inner_part, .enter = enter, .leave = leave};
}

#endif

/* The interval that a line shares with a closed convex shape, by name: which points of the line
 * its two ends are. Names can be
 * certain where numbers are rounded, so this is what every stage of `certain` and `exact` decides;
 * numbers come afterwards. */
#ifndef STAGES_INTERVAL_H
#define STAGES_INTERVAL_H

#include <surehit/ray.h>

#include <stdbool.h>

typedef enum {
    END_LESS,    /* the lesser root of the body's quadratic, or its only one */
    END_MORE,    /* the greater root */
    END_BASE,    /* where the line crosses the base's plane; the plane or the disc itself */
    END_TOP,     /* ... the plane of the top, or through the apex */
    END_START,   /* t_min, on a chord that is boundary as a whole */
    END_TANGENT, /* both roots in one, the vertex -b/a */
    END_ENDLESS, /* no point: a line within a plane has no ends */
} end_kind;

typedef struct {
    end_kind at;
    sure_part part;
} tagged_end;

typedef struct {
    bool empty;
    bool boundary;        /* the line misses the interior: all of the chord is boundary, ... */
    sure_part inner_part; /* ... and this is its part between the ends */
    tagged_end enter, leave;
} tagged_interval;

static inline tagged_interval interval_empty(void)
{
    return (tagged_interval){.empty = true};
}

static inline tagged_interval interval_between(tagged_end enter, tagged_end leave)
{
    return (tagged_interval){.enter = enter, .leave = leave};
}

static inline tagged_interval interval_point(tagged_end only)
{
    return interval_between(only, only);
}

/* A chord in the boundary. */
static inline tagged_interval interval_along(tagged_end enter, tagged_end leave,
                                             sure_part inner_part)
{
    return (tagged_interval){
        .boundary = true, .inner_part = inner_part, .enter = enter, .leave = leave};
}

#endif

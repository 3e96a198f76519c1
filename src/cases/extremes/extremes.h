/* Extreme cases whose truth is known by integer construction: a tangent, rim, apex, parallel or far
 * case is laid out in small integers in a frame where its answer can be read off, then turned by an
 * integer rotation, moved by integers and scaled by a power of two, all exact; a neighbour differs
 * from it by one ulp of the radius, in which every solid grows, or by one ulp of the ray's origin,
 * towards the side of a plane on which there is nothing. */
#ifndef CASES_EXTREMES_H
#define CASES_EXTREMES_H

#include <stdbool.h>

#include "../case.h"

typedef struct {
    sure_case question;
    sure_status status; /* the right answer */
    sure_part part;     /* on a hit */
    double t;           /* on a hit, where t_known: exactly t* */
    bool t_known;
} extreme;

/* A family of them: "tangent", "neighbour outside", ... */
int extreme_families(sure_shape shape);
const char *extreme_family_name(sure_shape shape, int family);

/* Member `index` (any number) of a family: pure and the same on every machine. */
extreme extreme_case(sure_shape shape, int family, uint64_t index);

/* Why the answer is what it is, in a line. */
const char *extreme_family_reason(sure_shape shape, int family);

#endif

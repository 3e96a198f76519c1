/* Where a ray on the lattice meets an object face by face, by the formulas: every point is (u +
 * v sqrt(root)) / w in integers, one root a case. Where the faces are taken together the
 * boundary of the solid is complete, so its first point, and its ends on the line, follow
 * without the notion of an interval. For checking an oracle that knows neither faces nor
 * formulas. */
#ifndef SUPPORT_FACE_BY_FACE_H
#define SUPPORT_FACE_BY_FACE_H

#include <stdbool.h>

#include "lattice.h"

typedef struct {
    long u, v, w; /* w > 0 */
} surd;

/* What one face has in common with the line; a point has low = high. */
typedef struct {
    surd low, high;
    sure_part part;
} piece;

/* An endless piece, of a line in a plane, has no bounds. */
typedef struct {
    long root;
    bool endless;
    int count;
    piece piece[6];
} faces;

faces faces_on_line(const lattice_case *c);

/* The sign of x - y; both of one case. */
int surd_order(surd x, surd y, long root);

/* Is y the double nearest to x, ties to even, and +0 for 0? */
bool surd_nearest(surd x, long root, double y);

/* Is y the correctly rounded component of the outward unit normal of this part where the line is
 * at x? */
bool normal_nearest(const lattice_case *c, sure_part part, surd x, long root, int component,
                    double y);

#endif

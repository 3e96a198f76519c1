/* A world of small integers in which a ray meets an object face by face, by the formulas: every
 * point is (u + v sqrt(root)) / w in integers, one root a case. Where the faces are taken
 * together the boundary of the solid is complete, so its first point, and its ends on the line,
 * follow without the notion of an interval. For checking an oracle that knows neither faces nor
 * formulas. */
#ifndef SUPPORT_FACE_BY_FACE_H
#define SUPPORT_FACE_BY_FACE_H

#include <stdbool.h>

#include <surehit/object.h>

typedef struct {
    long u, v, w; /* w > 0 */
} surd;

/* What one face has in common with the line; a point has low = high. */
typedef struct {
    surd low, high;
    sure_part part;
} piece;

/* Small integers: at most 4 in magnitude. The anchor is the point, centre or base; the axis the
 * normal or the way from the base to the other end, not zero unless the shape is a sphere. */
typedef struct {
    sure_shape shape;
    int origin[3], direction[3], anchor[3], axis[3], radius;
} small_case;

/* An endless piece, of a line in a plane, has no bounds. */
typedef struct {
    long root;
    bool endless;
    int count;
    piece piece[6];
} faces;

faces faces_on_line(const small_case *c);

/* The sign of x - y; both of one case. */
int surd_order(surd x, surd y, long root);

/* Is y the double nearest to x, ties to even, and +0 for 0? */
bool surd_nearest(surd x, long root, double y);

/* Is y the correctly rounded component of the outward unit normal of this part where the line is
 * at x? */
bool normal_nearest(const small_case *c, sure_part part, surd x, long root, int component,
                    double y);

#endif

/* A ray's line against one object, in the numbers of one stage: the chord's ends by name, and the
 * coefficients that say where they are. */
#ifndef STAGES_LINE_H
#define STAGES_LINE_H

#include "../shapes/chord.h"
#include "../numbers/number.h"

#include <surehit/object.h>

/* The body is a t^2 + 2 b t + c <= 0, with b^2 - a c = factor * quarter and factor > 0; the end
 * planes are crossed at base / speed and top / speed. What the object or the chord does not need is
 * not set. */
typedef struct {
    number a, b, c, factor, quarter;
    number speed, base, top;
} STAGE(line);

#define line STAGE(line)

chord STAGE(plane_chord)(context *, const sure_ray *, const sure_plane *, line *);
chord STAGE(disc_chord)(context *, const sure_ray *, const sure_disc *, line *);
chord STAGE(sphere_chord)(context *, const sure_ray *, const sure_sphere *, line *);
chord STAGE(cylinder_chord)(context *, const sure_ray *, const sure_cylinder *, line *);
chord STAGE(cone_chord)(context *, const sure_ray *, const sure_cone *, line *);

/* t = n/d of the vertex and of the end planes' crossings. */
void STAGE(line_rational)(context *, const line *, point at, number *n, number *d);

/* Sign of t - n/d for the point's t. Entry: d is not zero, the point is none of the ray's own. */
int STAGE(line_compare)(context *, const line *, point at, number n, number d);

/* Sign of root - x, from the sign of the body at x times a's (negative between the roots) and that
 * of x - vertex, the middle -b/a of the roots, which tells the sides and the roots apart. */
static inline int root_from_signs(point at, int outside, int side)
{
    if (outside < 0)
        return at == POINT_LESS ? -1 : 1;
    if (outside > 0)
        return -side;
    if (side == 0)
        return 0;
    if (side < 0)
        return at == POINT_LESS ? 0 : 1;
    return at == POINT_LESS ? -1 : 0;
}

/* The answer to one question about the ray: its status by `ends` and, if it is hit, the first
 * boundary point. */
sure_status STAGE(line_hit)(context *, const sure_ray *, const sure_object *, line *,
                            chord_end *first);

/* The same for the chord: have it and [t_min, t_max] a point in common? */
sure_status STAGE(line_interval)(context *, const sure_ray *, const sure_object *, line *,
                                 chord *ends);

#endif

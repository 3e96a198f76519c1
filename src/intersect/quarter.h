/* The discriminant for a filter that is certain of everything else: what makes grazing and tangent
 * rays hard is this number alone. */
#ifndef INTERSECT_QUARTER_H
#define INTERSECT_QUARTER_H

#include <surehit/object.h>

#include <stdbool.h>

/* Of certain sign, and |value - (b^2 - a c) / factor| <= error: r^2 d.d - |d x m|^2 for the sphere,
 * r^2 |A x d|^2 - (A.(d x m))^2 for the cylinder, r^2 H |d x m|^2 - (H + r^2) (A.(d x m))^2 for the
 * cone (their _chord.c). */
typedef struct {
    double value, error; /* both 0 for a tangent */
    sure_stage stage;
} quarter;

/* A filter takes it when error^2 is at most this share of |value| times the positive term of what
 * it is the difference of (docs/proofs/root.md). */
#define QUARTER_SHARE 0x1p-98

/* By double-doubles, then with residues; false where neither can tell. Entry: what question_of made
 * of a sphere, cylinder or cone. Any environment. */
bool quarter_of(const sure_ray *ray, sure_shape shape, const void *object, quarter *found);

#endif

/* The discriminant for a filter that is certain of everything else: what makes grazing and tangent
 * rays hard is this number alone. docs/proofs/quarter.md proves the bound. */
#ifndef SHAPES_QUARTER_H
#define SHAPES_QUARTER_H

#include <surehit/object.h>

#include <stdbool.h>

/* Of certain sign, |value + rest - (b^2 - a c) / factor| <= error, |rest| <= 2^-53 |value|; that is
 * r^2 d.d - |d x m|^2 for the sphere, r^2 |A x d|^2 - (A.(d x m))^2 for the cylinder, r^2 |A x (d x
 * m)|^2 - A.A (A.(d x m))^2 for the cone (quarter_terms.c). */
typedef struct {
    double value, rest, error; /* all 0 for a tangent */
    bool vanishes;             /* both of its terms are 0: a cone's apex, a cylinder's axis */
    bool level;                /* the line is known to be in an end plane */
    sure_stage stage;
} quarter;

/* The sphere's filter takes it when error^2 is at most this share of |value| times the positive
 * term of what it is the difference of (docs/proofs/root.md). */
#define QUARTER_SHARE 0x1p-98

/* By pairs of doubles, then by the last digits; false where neither can tell. Entry: a sphere that
 * filter_scales takes, or a cylinder or cone that axial_scales takes. Any environment. */
bool quarter_of(const sure_ray *ray, sure_shape shape, const void *object, quarter *found);

#endif

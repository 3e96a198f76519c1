/* SPDX-License-Identifier: MIT */
/* An object along a ray, as polynomials in t.
 *
 *   P(tau) = O + tau D    the ray in integers; t = tau * 2^shift
 */
#ifndef REFERENCE_BISECTION_LINE_H
#define REFERENCE_BISECTION_LINE_H

#include "bisection_shape.h"

/* What of the ray's line belongs to the object. */
typedef struct {
    bool empty;
    bool endless; /* a line in a plane: no ends */
    bool solid;   /* meets the interior, so that its ends alone are boundary */
    location enter, leave;
} chord;

typedef struct {
    polynomial body, inner[PLANES_MOST];
    int planes;
    chord chord;
} line;

void line_init(line *l, int planes);
void line_clear(line *l);

void ray_point(const world *w, int tau, vector *out);

/* From a polynomial in tau to a positive multiple of it in t. */
void substitute_t(const world *w, polynomial *p, unsigned degree);

/* The quadratic that has the values of the object's body. */
void body_on_line(const world *w, polynomial *out);

/* How far P is on the inner side of each plane. */
void planes_on_line(const world *w, polynomial *inner);

/* Of `body` and `inner`. */
void find_chord(line *l);

/* The first plane that t is on; -1 for none. */
int plane_at(const line *l, const location *t);

/* The outward unit normal there, each component rounded to nearest. */
sure_vec3 normal_at(const world *w, const line *l, const location *t);

#endif

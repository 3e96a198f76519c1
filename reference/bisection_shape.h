/* SPDX-License-Identifier: MIT */
/* The shapes of the bisection oracle, in integers: a row each, in bisection_<shape>.c. At a point P
 * whose offset from the anchor (centre, point or base) is W, with the axis A (the normal, or from
 * the anchor to the other end), an object is where its body is not positive and P is on the inner
 * side of all its planes. Nothing else is known of a shape: its quadratic along the ray and its
 * normals are read off the values of these functions.
 *
 * The rows are this oracle's own data: it believes no table of the library. */
#ifndef REFERENCE_BISECTION_SHAPE_H
#define REFERENCE_BISECTION_SHAPE_H

#include "bisection_number.h"

#include <surehit/object.h>

typedef struct {
    mpz_t x[3];
} vector;

void vector_init(vector *v);
void vector_clear(vector *v);
void vector_subtract(vector *out, const vector *v, const vector *w);
/* out must not be a component of v or w. */
void dot(mpz_t out, const vector *v, const vector *w);

/* What a field holds decides its unit and its place in the world; a row's fields are in the order
 * of the struct and of the contract. */
typedef enum { NO_FIELD, ANCHOR, OTHER_END, NORMAL, RADIUS } field_kind;

/* By the values alone; anchor is the first field's. */
typedef bool field_valid(const double *value, const double *anchor);
field_valid valid_point, valid_end, valid_normal, valid_radius;

typedef struct {
    sure_field name;
    field_kind kind;
    field_valid *valid;
} row_field;

/* The ray and the object in integers: lengths count one power of two, the direction another and a
 * plane's or disc's normal a third. */
typedef struct world world;

/* P is on the inner side where outward.W <= reach. */
typedef struct {
    vector outward;
    mpz_t reach;
} plane;

enum { FIELDS_MOST = 3, PLANES_MOST = 6 };

/* Where a point is on several planes, the first one's part and normal count. */
typedef struct {
    row_field fields[FIELDS_MOST];
    void (*body)(const world *w, const vector *p, mpz_t out);
    sure_part body_part;
    int planes;
    void (*plane)(const world *w, int index, plane *out);
    sure_part plane_part[PLANES_MOST];
} bisection_row;

struct world {
    const bisection_row *row;
    vector origin, direction, anchor, axis;
    mpz_t radius, axis_square;
    long shift; /* P(tau) = O + tau D is the ray in integers; t = tau * 2^shift */
};

#define DECLARE(shape, SHAPE) extern const bisection_row bisection_##shape;
SURE_EACH_SHAPE(DECLARE)
#undef DECLARE

/* The first invalid field of ray and object; where there is none, *w is initialised. */
sure_field world_init(world *w, const sure_ray *ray, const sure_object *object);
void world_clear(world *w);

/* W.A, from 0 at the base to A^2 at the other end; W^2. */
void height(const world *w, const vector *p, mpz_t out);
void distance_square(const world *w, const vector *p, mpz_t out);

/* A^2 W^2 - (A.W)^2, which is A^2 times the squared distance from the axis. */
void axis_distance(const world *w, const vector *p, mpz_t out);

/* W^2 - r^2. */
void ball(const world *w, const vector *p, mpz_t out);

/* The planes A.W <= 0 and 0 <= A.W; 0 <= A.W and A.W <= A^2. */
void flat_planes(const world *w, int index, plane *out);
void end_planes(const world *w, int index, plane *out);

#endif

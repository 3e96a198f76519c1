/* SPDX-License-Identifier: MIT */
/* How a case is made: laid out in the object's own frame, where a tangent or a rim is easily said,
 * then turned, moved and scaled into the world. */
#pragma once

#include "../case.h"
#include "../rng.h"
#include "../../numbers/sums.h"

/* The object's own frame: the plane's point, the centre or the base centre is the origin; the
 * normal is +z; the top centre or the apex is (0, 0, h). */
typedef struct {
    sure_shape shape;
    double r;       /* for a plane only the size of what happens on it */
    double h;       /* of what has a height */
    sure_vec3 p, d; /* the ray's line, p + s d ... */
    double t;       /* ... and the ray's t at p: the ray starts at p - t d */
    double t_min, t_max;
} layout;

/* A point x goes to 2^scale (turn x + move), a length r to 2^scale stretch r, d to 2^d_scale turn
 * d, a normal to 2^n_scale turn n, t to 2^(scale - d_scale) t. */
typedef struct {
    sure_mat3 turn; /* stretch times a rotation */
    double stretch;
    sure_vec3 move;
    int scale, d_scale, n_scale;
} pose;

sure_case place(const layout *lay, const pose *where);

/* Turned by the quaternion q, not zero, and stretched by |q|^2: whole where q is; neither moved nor
 * scaled. */
pose pose_turned(sure_shape shape, const double q[4]);

/* The most binary digits that a layout in whole numbers may have: its sizes, the steps and the
 * parts of a cone, a direction's components, the ray's t at p. Coordinates follow, of up to 31
 * digits. */
enum { SIZE_BITS = 14, STEP_BITS = 7, PART_BITS = 6, WAY_BITS = 20, TIME_BITS = 10 };

/* A whole number of up to SIZE_BITS digits, in a quarter of draws 1. */
double random_whole_size(rng *g);

/* A whole number of up to TIME_BITS digits, in a tenth of draws negative. */
double random_t(rng *g);

/* A rotation by an integer quaternion, which places such a layout without rounding: turned
 * coordinates stay below 2^47, moves below 2^46. In a quarter of draws as scenes have it: unturned
 * or turned about an axis, near the origin, hardly scaled. Else entries of turn reach 2^14 and
 * scales 2^+-60, so that the coefficients of the object's equation do not fit a double. */
pose pose_exact(sure_shape shape, rng *g);

/* The same for a ray that starts as far as 2^45 from p: the quaternion's entries are at most 3, the
 * moves below 2^36. */
pose pose_exact_far(sure_shape shape, rng *g);

/* By 2^-most .. 2^most: lengths, direction and normal, each by itself. */
void scale_anyhow(pose *where, int most, rng *g);

/* Any rotation, up to rounding; moved by 2^-10 .. 2^move_bits along each axis, or, in a quarter of
 * draws, not at all. */
pose pose_general(sure_shape shape, rng *g, int move_bits);

/* Placed so. */
sure_case place_exactly(const layout *lay, rng *g);
sure_case place_generally(const layout *lay, rng *g, int move_bits);

/* Placed so with an end of the range at lay->t, or none; in one of so many draws nudged then. */
sure_case place_at_t(layout *lay, pose (*how)(sure_shape, rng *), int one_in, rng *g);

/* r and h in whole numbers; the ray is left open. */
layout whole_layout(sure_shape shape, rng *g);

/* r and h within 2^low .. 2^high; the ray is left open. */
layout random_body(sure_shape shape, rng *g, int low, int high);

/* [0, inf) in three of four draws, else finite at one end or both, cut at values about `about`. */
void range_usual(layout *lay, rng *g, double about);

/* [0, inf) in a third of draws, else a range with an end at lay->t, where something happens, or at
 * its neighbour. Where lay->t < 0, in the ray's back: [0, inf). */
void range_at_t(layout *lay, rng *g);

double largest(sure_vec3 v); /* of the components' sizes */

/* Is it a coordinate of one of the object's points? */
bool is_coordinate(sure_shape shape, int number);

/* Moves one finite number of the case, any, by 1 to 4 neighbours; a valid case stays valid. */
void nudge(sure_case *c, rng *g);

/* Moves one coordinate of the ray's start to a neighbour. */
void step_start(sure_case *c, rng *g);

/* One maker a regime. `g` is fresh: it knows seed, regime and index. */
#define REGIME(NAME, name, key, of) sure_case make_##name(sure_shape shape, rng *g);
#include "../regimes.def"
#undef REGIME

/* A point p in whole numbers on the boundary; direction, t and range are left open. */
layout surface_layout(sure_shape shape, rng *g);

/* Exactly tangent at p, or through a point p of a rim; the range is left open. */
layout touch_layout(sure_shape shape, rng *g);

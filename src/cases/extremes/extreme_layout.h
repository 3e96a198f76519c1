/* How an extreme case is made: laid out in small integers in a frame of its own, where its answer
 * can be read off, then carried into the world by steps that are all exact. */
#ifndef CASES_EXTREME_LAYOUT_H
#define CASES_EXTREME_LAYOUT_H

#include <stdbool.h>
#include <stdint.h>

#include "extremes.h"
#include "../rng.h"

typedef struct {
    int64_t x, y, z;
} grid_vec;

int64_t grid_dot(grid_vec a, grid_vec b);
grid_vec grid_times(int64_t factor, grid_vec a);

/* One of lowest, ..., highest. */
int64_t draw_grid(draws *from, int64_t lowest, int64_t highest);

int64_t draw_size(draws *from);   /* 1 .. 1000 */
int64_t draw_slope(draws *from);  /* -99 .. -1, 1 .. 99 */
int64_t draw_side(draws *from);   /* -1, 1 */
grid_vec draw_slopes(draws *from);
grid_vec draw_floor(draws *from); /* -999 <= x, y <= 999, z = 0 */

/* 2^low .. 2^high, 14 <= low < high, about evenly over the powers. */
int64_t draw_wide(draws *from, int low, int high);

/* Rational points of the circle: u * u + v * v = w * w with u > 0, w > |v| > 0. */
typedef struct {
    int64_t u, v, w;
} triple;

triple draw_triple(draws *from);

/* Which of a family's kinds the member is: 0 .. kinds - 1 in turn. */
int kind_of(const draws *from, int kinds);

/* Where [t_min, t_max] lies against the time `at`. */
typedef enum { WHOLE_RAY, CLOSES_AT, CLOSES_BEFORE, OPENS_AT, OPENS_AFTER } extreme_window;

/* The frame's origin is a plane's point, a disc's or sphere's centre, a base's centre. */
typedef struct {
    grid_vec axis; /* the normal; the top's centre or the apex */
    int64_t radius;
    grid_vec point, direction; /* of the ray's line */
    int64_t at;                /* the time of `point`: the ray starts at point - at * direction */
    grid_vec outward;          /* the object lies in outward . p <= outward . point */

    int radius_ulps;  /* -1, 0 or 1: a change of the radius's last bit, made in the world */
    bool off_outward; /* the ray's start is moved outward by the last bit of one coordinate */
    extreme_window window;

    sure_status status;
    sure_part part;
    int64_t later; /* t* is at + later */
    bool t_known;

    int turn;   /* bound on the components of the quaternion that turns the frame */
    int scale;  /* every length is multiplied by 2^scale */
    int stride; /* and the direction by 2^stride, so that t is by 2^(scale - stride) */
} extreme_layout;

/* A hit of `surface` at a known time, to be completed; axis along z, sizes up to 1000. */
extreme_layout lay_plain(draws *from);

/* In the plane of a disc or cap, from outside: the chord begins at a rational point of the rim. */
extreme_layout lay_edge_on(draws *from);

/* From inside a cylinder, and a cone as well, out through the inside of the base. */
extreme_layout lay_exit_through_base(draws *from);

/* The object mirrored: what happened at the base happens at the top (cylinder). */
void turn_upside_down(extreme_layout *it);

/* The ray enters at `point` and takes `chord` to `leave`: t_min or t_max is set to the time of one
 * of the two or to the next double. */
void lay_window(extreme_layout *it, grid_vec leave, int64_t chord, const draws *from);

/* The ray starts at `point`, a hit at once; every second member starts one ulp outward, heads away
 * and misses. */
void lay_start(extreme_layout *it, draws *from);

/* The radius one ulp smaller, the radius one ulp larger, the start one ulp outward. Where
 * the object is met in one point only, the first and last make a miss, the second a hit still. */
void miss_by_radius(extreme_layout *it);
void hit_by_radius(extreme_layout *it);
void miss_by_start(extreme_layout *it);

/* One family: laid out, then changed (unless NULL). */
typedef struct {
    const char *name;
    extreme_layout (*lay)(draws *from);
    void (*change)(extreme_layout *it, draws *from);
    const char *reason;
} extreme_family;

typedef struct {
    const extreme_family *list;
    int count;
} extreme_family_list;

#define EXTREME_FAMILIES(list) {(list), (int)(sizeof(list) / sizeof((list)[0]))}

extern const extreme_family_list plane_extremes, disc_extremes, sphere_extremes, cylinder_extremes,
    cone_extremes;

/* Changes for the tables. */
void change_to_smaller(extreme_layout *it, draws *from); /* miss_by_radius */
void change_to_larger(extreme_layout *it, draws *from);  /* hit_by_radius */
void change_to_outside(extreme_layout *it, draws *from); /* miss_by_start */
void change_to_far(extreme_layout *it, draws *from);     /* from up to 2^45 away */
void change_to_huge(extreme_layout *it, draws *from);    /* lengths 1e200 .. 1e300 */
void change_to_tiny(extreme_layout *it, draws *from);    /* lengths 1e-300 .. 1e-200 */

/* Turned, moved and scaled: as true as the layout, for no step rounds. */
extreme carry_into_world(sure_shape shape, const extreme_layout *it, draws *from);

#endif

/* SPDX-License-Identifier: MIT */
/* What the regimes must know of a shape: a row a shape, src/cases/shapes/<shape>.c. All is said in
 * the frame of regimes_layout.h. */
#pragma once

#include "../moved.h"
#include "../regimes/regimes_layout.h"

/* What a shape has; a regime that is about it applies then. */
enum {
    CASE_HAS_INSIDE = 1, /* told by sure_shape_info, not by the row */
    CASE_HAS_RIM = 2,    /* a point (r, 0) at the height of a cap */
    CASE_HAS_AXIS = 4,   /* a side that is parallel to z, or nearly */
    CASE_HAS_APEX = 8,
    CASE_HAS_FLAT = 16,     /* a face z = 0 */
    CASE_HAS_HEIGHT = 32,   /* the layout's h means something */
    CASE_HAS_TWO_CAPS = 64, /* z = h is a face, too */
    CASE_HAS_NO_END = 128,  /* the face z = 0 is unbounded */
    CASE_HAS_PICTURE = 256  /* told by the pictures of the regime camera */
};

/* Vectors of -1, 0, 1. */
enum { SMALL_VECTORS = 27, SMALL_ZERO = 13 };

/* A point on the boundary, any part, and the unit normal there, of a solid outwards. */
typedef struct {
    sure_vec3 p, normal;
} boundary_point;

/* The values of t at which the ray may cross the boundary, as double finds them. */
typedef struct {
    double t[SURE_SHAPE_PARTS];
    int count;
} crossings;

typedef struct {
    unsigned has;

    /* Placing: a rotation, times |q|^2, for the quaternion q; the points that are the object's
     * point fields, in their order; a length that no point of the object is farther than from the
     * frame's origin (of a plane, none that is aimed at). */
    sure_mat3 (*turn)(const double q[4]);
    void (*points)(const layout *lay, sure_vec3 point[2]);
    double (*reach)(const layout *lay);

    /* A point inside the solid; of a plane or disc, on it. */
    sure_vec3 (*inner)(const layout *lay, rng *g);
    boundary_point (*boundary)(const layout *lay, rng *g);

    /* In whole numbers: p and d such that the ray is exactly tangent at p; a boundary point p on
     * the side, or on a cap; and one with a direction that enters there. NULL: it has none such. */
    void (*tangent)(layout *lay, rng *g);
    void (*on_side)(layout *lay, rng *g), (*on_cap)(layout *lay, rng *g);
    void (*enter_side)(layout *lay, rng *g), (*enter_cap)(layout *lay, rng *g);

    /* Where the ray, which starts at p, crosses the boundary. */
    void (*cross)(crossings *all, const layout *lay);

    /* Its faces moved (moved.h). */
    bool (*moved)(const double *object, const movement *how, double *to);
    bool (*slab)(const double *object, double by, sure_object *slab); /* or NULL */

    /* The infinite wall by exact, where there is one (cylinder_wall.h, cone_wall.h); moved where it
     * stays one. */
    sure_status (*wall_hit)(const sure_ray *ray, const void *object, sure_hit *hit);
    int (*wall_side)(const sure_ray *ray, const void *object);
    bool (*wall_moved)(const sure_object *object, const movement *how, sure_object *to);

    /* The objects of the regime integers: how many, and which one a code below that is. */
    int small_objects;
    void (*small_object)(sure_case *c, uint64_t code);
} case_shape;

#define CASE_WALL(shape)                                                                           \
    static sure_status wall_hit(const sure_ray *ray, const void *object, sure_hit *hit)            \
    {                                                                                              \
        return sure_##shape##_wall_hit_exact(ray, object, hit);                                    \
    }                                                                                              \
    static int wall_side(const sure_ray *ray, const void *object)                                  \
    {                                                                                              \
        return sure_##shape##_wall_side_exact(ray, object);                                        \
    }

/* Entry: shape is a member. */
const case_shape *case_shape_of(sure_shape shape);

/* Does the shape have all of them? */
bool case_shape_has(sure_shape shape, unsigned what);

/* What several rows share. */

sure_mat3 turn_any(const double q[4]);
void points_on_axis(const layout *lay, sure_vec3 point[2]); /* the origin and (0, 0, h) */
double reach_of_rim(const layout *lay);                     /* of (r, h) */
void small_fields(sure_case *c, uint64_t code);

/* Of a shape whose points are on its axis, and which may be turned. */
#define CASE_ON_AXIS                                                                               \
    .turn = turn_any, .points = points_on_axis, .reach = reach_of_rim, .small_object = small_fields

/* Of a cylinder or cone; radii 0 .. 2. */
#define CASE_CAPPED                                                                                \
    CASE_ON_AXIS, .inner = random_in_body, .boundary = random_boundary_point, .on_cap = on_cap,    \
                  .enter_cap = enter_cap, .small_objects = 3 * SMALL_VECTORS * (SMALL_VECTORS - 1)

sure_vec3 random_in_circle(rng *g, double r, double z); /* within, but not in the middle */
sure_vec3 random_in_base(const layout *lay, rng *g);
boundary_point random_cap_point(const layout *lay, rng *g);

/* Of a plane or disc: along the normal, and the rim. */
bool moved_flat(const double *object, const movement *how, double *to);

/* Of a cylinder or cone. */
sure_vec3 random_in_body(const layout *lay, rng *g);
boundary_point random_boundary_point(const layout *lay, rng *g);

/* The height of a cap, any. */
double random_cap(const layout *lay, rng *g);

/* A ray in the plane of the caps that touches their circle at (r, 0). */
void tangent_at_rim(layout *lay, rng *g);

/* A height on the side of 0..h: a rim, between the rims, or (of the infinite side only) beyond
 * them. */
double random_side_height(double h, rng *g);

/* A whole distance from the axis of at most r. */
double random_within(double r, rng *g);

/* The point p in a cap. */
void on_cap(layout *lay, rng *g);

/* p on the cap z = 0 or h, at the distance x of the axis; or on the side. */
void enter_flat(layout *lay, bool top, double x, rng *g);
void enter_cap(layout *lay, rng *g);
void enter_side(layout *lay, rng *g);

/* A whole vector against the normal `outwards`. */
sure_vec3 random_entering(rng *g, sure_vec3 outwards);

/* A height for the regime midpoint. */
double random_step_height(rng *g);

/* Of the base; of the plane z = height, within r of the axis; of a t^2 + 2 half_b t + c = 0,
 * between the caps if there are any. */
void cross_base(crossings *all, const layout *lay);
void cross_flat(crossings *all, const layout *lay, double height);
void cross_round(crossings *all, const layout *lay, double a, double half_b, double c);

/* The quadratic's terms of x and y alone: d d, o d, o o. */
typedef struct {
    double dd, od, oo;
} across;

across across_axis(const layout *lay);

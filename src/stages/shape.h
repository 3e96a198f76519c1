/* What the stages ask of a shape: one row a shape. src/shapes/shapes.c has the table; what a row
 * points to lives in the shape's folder. */
#ifndef STAGES_SHAPE_H
#define STAGES_SHAPE_H

#include "../numbers/mod128.h"
#include "filter.h"
#include "last/line.h"

#include <surehit/shape.h>

#include <stddef.h>

/* t within t_error, or correctly rounded. */
typedef enum { T_CERTAIN, T_EXACT } t_wanted;

typedef struct shape_row {
    sure_shape_info info;

    /* The first stage, in doubles. */
    filter_verdict (*filter)(const sure_ray *, const void *shape, filter_interval *);

    /* The second: the same with coefficients as double-doubles, then modulo 2^128. Asked for the
     * first boundary point of [t_min, t_max] alone, or for both ends of the interval. */
    filter_verdict (*refine)(const sure_ray *, const void *shape, bool both_ends, filter_interval *,
                             sure_stage *);

    /* In the place of refine and polish for hits of planar shapes. Entry: round to nearest. */
    filter_verdict (*refine_hit)(const sure_ray *, const void *shape, t_wanted, sure_hit *);

    /* t* correctly rounded, of an end that is certain and no tangent, or false. Entry: round to
     * nearest. */
    bool (*polish)(const sure_ray *, const void *shape, const filter_end *, double *t);

#ifdef MOD128_EXISTS
    /* Half the slope of the body along the ray, at o + x d. */
    mod128 (*slope)(const sure_ray *, const void *shape, double x);
#endif

    /* The last stage: the interval in exact numbers, and the normal at its first end. */
    tagged_interval (*exact_interval)(exact_context *, const sure_ray *, const void *shape,
                                      line_coefficients *);
    sure_vec3 (*round_normal)(exact_context *, const sure_ray *, const void *shape,
                              const line_coefficients *, tagged_end);

    /* What is asked of a hit (hits/surface.h). */
    const struct surface_row *surface;
} shape_row;

/* The rows: each is defined in its shape's folder. */
#define DECLARE_ROW(shape, SHAPE)                                                                  \
    extern const shape_row shape##_row;                                                            \
    extern const struct surface_row shape##_surface_row;
SURE_EACH_SHAPE(DECLARE_ROW)

/* How many doubles stand before a field of a shape's struct. */
#define DOUBLES_BEFORE(type, field) ((int)(offsetof(type, field) / sizeof(double)))

/* The first invalid field of ray or shape, in the contract's order. */
sure_field shape_check(const shape_row *row, const sure_ray *ray, const void *shape);

#endif

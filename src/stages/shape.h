/* What the stages ask of a shape: one row a shape. src/shapes/shapes.c has the table; what a row
 * points to lives in the shape's folder. */
#ifndef STAGES_SHAPE_H
#define STAGES_SHAPE_H

#include "filter.h"
#include "hits/interaction.h"
#include "last/line.h"

#include <surehit/object.h>

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

    /* Where the ray is tangent: the sign of t* - x, by the low bits; false where it can't be
     * told. */
    bool (*tangent_order)(const sure_ray *, const void *shape, double x, int *sign);

    /* t* correctly rounded, of an end that is certain, or false. Entry: round to nearest. */
    bool (*polish)(const sure_ray *, const void *shape, const filter_end *, double *t);

    /* In the place of refine and polish for hits of planar shapes. Entry: round to nearest. */
    filter_verdict (*refine_hit)(const sure_ray *, const void *shape, t_wanted, sure_hit *);

    /* The last stage: the interval in exact numbers, and the normal at its first end. */
    tagged_interval (*exact_interval)(exact_context *, const sure_ray *, const void *shape,
                                      line_coefficients *);
    sure_vec3 (*round_normal)(exact_context *, const sure_ray *, const void *shape,
                              const line_coefficients *, tagged_end);

    /* The surface at a hit (interaction.h), and on which side of it a point is (where.h). */
    surface_functions surface;
    int (*side_ddb)(ddb_context *, const void *shape, sure_vec3 p);
    int (*side_exact)(exact_context *, const void *shape, sure_vec3 p);

    /* What spawn.c tries first, and the stage before that (spawn_quick.h). */
    sure_vec3 (*outward)(const void *shape, sure_part part, sure_vec3 p);
    bool (*spawn_quick)(const sure_ray *, const void *shape, const sure_hit *, double side,
                        sure_vec3 *origin, sure_hit *nearer);
    bool (*has_inside)(const void *shape);

    /* Makes a box larger, so that it holds the object; NULL where no box does. */
    void (*bounds)(const void *shape, double low[3], double high[3]);
} shape_row;

/* How many doubles stand before a field of a shape's struct. */
#define DOUBLES_BEFORE(type, field) ((int)(offsetof(type, field) / sizeof(double)))

extern const shape_row *const shape_rows[SURE_SHAPES];

static inline const shape_row *row_of(const sure_object *object)
{
    return shape_rows[object->shape];
}

#endif

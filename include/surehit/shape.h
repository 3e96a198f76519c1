/* The shapes, and what each is made of: data for those who handle any of them. */
#ifndef SUREHIT_SHAPE_H
#define SUREHIT_SHAPE_H

#include <surehit/answer.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    SURE_SHAPE_PLANE,
    SURE_SHAPE_DISC,
    SURE_SHAPE_SPHERE,
    SURE_SHAPE_CYLINDER,
    SURE_SHAPE_CONE
} sure_shape;

#define SURE_SHAPES 5

/* Every shape once, in that order, for tables: DO(plane, PLANE) ... */
#define SURE_EACH_SHAPE(DO)                                                                        \
    DO(plane, PLANE) DO(disc, DISC) DO(sphere, SPHERE) DO(cylinder, CYLINDER) DO(cone, CONE)

/* What a field holds. */
typedef enum {
    SURE_KIND_POINT,       /* finite */
    SURE_KIND_OTHER_POINT, /* finite, and not the first field's point */
    SURE_KIND_NORMAL,      /* finite, not zero */
    SURE_KIND_RADIUS       /* one number: finite, not negative */
} sure_kind;

typedef struct {
    sure_field name;
    sure_kind kind;
    int at; /* so many doubles of the shape's struct stand before it */
} sure_shape_field;

#define SURE_SHAPE_FIELDS 3
#define SURE_SHAPE_PARTS 6
#define SURE_SHAPE_NUMBERS 7

/* A shape as data. Its struct is `numbers` doubles, those of its fields, in the contract's
 * order. */
typedef struct {
    const char *name;
    int solid;   /* has an inside */
    int bounded; /* lies in a box */
    int numbers, field_count, part_count;
    sure_shape_field fields[SURE_SHAPE_FIELDS];
    sure_part parts[SURE_SHAPE_PARTS];
} sure_shape_info;

/* Entry: shape is a member. */
const sure_shape_info *sure_shape_info_of(sure_shape shape);

/* "plane", "disc", "sphere", "cylinder", "cone": the shapes of the case format; NULL for a number
 * that is no shape. */
const char *sure_shape_name(sure_shape shape);

/* Finds the shape of that name: 1 and *shape written, or 0 and *shape untouched. */
int sure_shape_from_name(const char *name, sure_shape *shape);

#ifdef __cplusplus
}
#endif
#endif

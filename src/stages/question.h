/* A question made fit for the stages of bounded range: where its numbers are very large or small,
 * lengths and directions are scaled by powers of two, which no decision notices. */
#ifndef STAGES_QUESTION_H
#define STAGES_QUESTION_H

#include "../numbers/bits.h"

#include <surehit/object.h>

typedef struct {
    const sure_ray *asked; /* as it was */
    const sure_ray *ray;   /* as it is to be taken: asked and the asked object, or these: */
    const sure_object *object;
    sure_ray scaled_ray;
    sure_object scaled_object;
    int t_exponent, length_exponent; /* a true t is the question's times 2^t_exponent, ... */
} question;

/* Where lengths, directions and normals are 0 or between 2^-30 and 2^30, they are taken as they
 * are; otherwise each of these three is scaled so that its largest is near 1, and where others are
 * then less than 2^-QUESTION_SPREAD but not 0, the answer is false. t_min and t_max may lie beyond
 * what a stage tells apart (NUMBER_RANGE), but stay on their side of it. Entry: valid input that
 * outlives the question. */
#define QUESTION_SPREAD 100
bool question_of(const sure_ray *ray, const sure_object *object, question *q);

/* x 2^exponent; false when that might be rounded. */
static inline bool question_shift(double x, int exponent, double *shifted)
{
    int result = exponent_of(x) + exponent;
    *shifted = double_of(bits_of(x) + ((uint64_t)exponent << 52));
    return result > -900 && result < 1000 && exponent_of(x) > -1000;
}

/* A t of the question as one of the asked ray. */
static inline bool question_unscale(const question *q, double t, double *asked)
{
    return question_shift(t, q->t_exponent, asked);
}

#endif

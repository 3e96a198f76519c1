/* Refraction by its angles, in 500 bits: t from Snell's law, the direction by turning from the
 * normal by t, and the share that is reflected as what is not transmitted. */
#ifndef SUPPORT_REFRACTION_TRUTH_H
#define SUPPORT_REFRACTION_TRUTH_H

#include <mpfr.h>
#include <stdbool.h>

#include <surehit/refract.h>
#include <surehit/tier.h>

typedef struct {
    sure_vec3 d, n;
    double ratio;
} refraction_question;

typedef struct {
    mpfr_t direction[3]; /* of length |d| */
    mpfr_t length;       /* |d| */
    mpfr_t left;         /* 1 - (ratio sin i)^2: what is left for cos^2 t */
    mpfr_t share;
    double cosine, refracted; /* cos i, cos t */
} refraction_truth;

void refraction_truth_init(refraction_truth *truth);
void refraction_truth_clear(refraction_truth *truth);

/* SURE_HIT and all of *truth, or SURE_MISS and of it `length` and `left`. Entry: the ratio is not
 * 1. */
sure_status refraction_truth_of(refraction_truth *truth, const refraction_question *q);

/* How far the direction t is off the true one, over |d|. */
double refraction_direction_off(const refraction_truth *truth, sure_vec3 t);

/* The greatest of |N x t - ratio N x d|, ||t| - |d|| and N.t, over |d|, for N of length 1. */
double refraction_snell_off(const refraction_truth *truth, const refraction_question *q,
                            sure_vec3 t);

double refraction_share_off(const refraction_truth *truth, double share);

typedef struct {
    unsigned long refracted, total, mistaken; /* of the last: as far as the bound allows it */
} refraction_counts;

/* Laws 5, 6 and 10 of refract.h, and its bounds: what the tier breaks, or NULL. Entry: a question
 * in the tier's numbers. Asked are those for which the bounds are published. */
const char *refraction_broken(sure_tier tier, const refraction_question *q,
                              refraction_counts *count);

/* Do the vectors keep products of four of their numbers in the tier's range? */
bool refraction_is_moderate(sure_tier tier, const refraction_question *q);

#endif

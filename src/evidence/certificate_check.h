/* Is what a certificate says of a scene's picture true? */
#ifndef EVIDENCE_CERTIFICATE_CHECK_H
#define EVIDENCE_CERTIFICATE_CHECK_H

#include "certificate.h"

typedef struct {
    int threads;   /* 0: one a core */
    bool quick;    /* with the hierarchy, which a check is otherwise independent of */
    bool progress; /* a bar on standard error */
} check_options;

/* How a pixel's line is wrong. */
typedef enum {
    CLAIM_RIGHT,
    CLAIM_OBJECT, /* another object is seen, or none */
    CLAIM_PART,
    CLAIM_T,     /* it is farther off than its error says */
    CLAIM_VAGUE, /* the error is larger than docs/contract.md allows */
    CLAIM_VERDICTS
} claim_verdict;

typedef struct {
    int64_t pixels;
    int64_t found[CLAIM_VERDICTS]; /* lines of each */
    uint64_t acne;                 /* as the certificate says itself */
    bool totals_fit;               /* the totals go with one another and with the pixels */
} check_result;

bool check_is_right(const check_result *result);

/* Asks `exact` about every pixel. The first few that are wrong are printed to `out`, both answers
 * in a line. False after an error to `messages`: the scene can't be read, or is another one. */
bool certificate_check(const certificate *of, const char *scene, const check_options *options,
                       FILE *out, FILE *messages, check_result *result);

/* "57600 pixels, all right", or how many are wrong and how. */
void check_print_result(FILE *out, const check_result *result);

#endif

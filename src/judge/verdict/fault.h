/* What can be wrong with one answer, held against the right one. */
#ifndef JUDGE_FAULT_H
#define JUDGE_FAULT_H

#include "reply.h"

typedef enum {
    /* the decision, of a valid case */
    FAULT_FALSE_HIT,
    FAULT_FALSE_MISS,
    FAULT_WRONG_PART,
    FAULT_REFUSED, /* called invalid */
    /* the contract */
    FAULT_NOT_A_NUMBER, /* in t or the normal of a hit */
    FAULT_OUT_OF_RANGE, /* t of a hit is outside [t_min, t_max] */
    FAULT_INVALID_ACCEPTED,
    FAULT_WRONG_FIELD, /* of an invalid case, where it names one */
    FAULT_TOUCHED,     /* an output was written on a miss */
    FAULT_CHANGED,     /* a different answer on the same input */
    FAULT_LEAKED,
    /* no answer: a decision that is not made */
    FAULT_GARBAGE,
    FAULT_CRASHED,
    FAULT_HUNG,
    FAULT_LOST
} fault;

#define FAULTS 15
#define FAULTS_OF_DECISION 4 /* the first */
#define FAULTS_ANSWERED 11   /* the first: those of an answer that could be read */

/* "false hit", ... */
const char *fault_name(fault which);

/* Has answer and truth the status hit, so that their t can be compared? */
bool fault_is_hit(const case_answer *truth, const reply *given);

/* The set of them: bit n is fault n. `question` is as the candidate was asked it. */
unsigned faults_of(const sure_case *question, const case_answer *truth, const reply *given);

#define FAULT_BIT(which) (1u << (which))

#endif

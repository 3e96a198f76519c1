/* What can be wrong with one answer, held against the right one. */
#ifndef JUDGE_FAULT_H
#define JUDGE_FAULT_H

#include "reply.h"

/* clang-format off */
#define EACH_FAULT(DO) \
    /* the decision, of a valid case */ \
    DO(FALSE_HIT, "false hit") \
    DO(FALSE_MISS, "false miss") \
    DO(WRONG_PART, "wrong part") \
    DO(REFUSED, "valid refused") /* called invalid */ \
    /* the contract */ \
    DO(NOT_A_NUMBER, "not a number")   /* in t or the normal of a hit */ \
    DO(OUT_OF_RANGE, "t out of range") /* t of a hit is outside [t_min, t_max] */ \
    DO(INVALID_ACCEPTED, "invalid accepted") \
    DO(WRONG_FIELD, "wrong field") /* of an invalid case, where it names one */ \
    DO(TOUCHED, "outputs touched") /* on a miss */ \
    DO(CHANGED, "answer changes")  /* on the same input */ \
    DO(LEAKED, "leak") \
    /* no answer: a decision that is not made; in the order of reply_kind */ \
    DO(GARBAGE, "garbage") \
    DO(CRASHED, "crash") \
    DO(HUNG, "no answer in time") \
    DO(LOST, "no answer")
/* clang-format on */

#define FAULT(NAME, name) FAULT_##NAME,
typedef enum { EACH_FAULT(FAULT) FAULTS } fault;
#undef FAULT

#define FAULTS_OF_DECISION FAULT_NOT_A_NUMBER /* so many: the first */
#define FAULTS_ANSWERED FAULT_GARBAGE         /* the first: those of an answer that could be read */

/* "false hit", ... */
const char *fault_name(fault which);

/* Has answer and truth the status hit, so that their t can be compared? */
bool fault_is_hit(const case_answer *truth, const reply *given);

/* The set of them: bit n is fault n. `question` is as the candidate was asked it. */
unsigned faults_of(const sure_case *question, const case_answer *truth, const reply *given);

#define FAULT_BIT(which) (1u << (which))

#endif

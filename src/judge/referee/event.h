/* SPDX-License-Identifier: MIT */
/* What happens in a case: where a routine may have another convention than the contract. */
#pragma once

#include "../verdict/tally.h"

/* clang-format off */
#define EACH_EVENT(DO) \
    DO(SURFACE, "surface") /* the ray starts on the boundary */ \
    DO(INSIDE, "inside")   /* ... in the interior */ \
    DO(END, "end")         /* of all its range only the end hits */ \
    DO(TOUCH, "touch")     /* no double t is in the interior; of a disc: at the rim alone */ \
    DO(TIE, "tie")         /* the part that was named has the hit, too, but for roundings */ \
    DO(CLEAR, "clear")     /* none of them */
/* clang-format on */

#define EVENT(NAME, name) EVENT_##NAME,
typedef enum { EACH_EVENT(EVENT) EVENTS } event;
#undef EVENT

/* "surface", ... */
const char *event_name(int which);

/* The first of them that it is. Entry: a valid case; the fault, if any (else FAULTS), is one of
 * decision. By the tier exact. */
event event_of(const sure_case *question, const case_answer *truth, fault which,
               const reply *given);

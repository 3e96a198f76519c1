#include "candidate.h"

#include <stddef.h>

/* So many in a row of cases, and it is given up: each costs a restart, and the latter the time
 * limit. */
#define MOST_CRASHES 16
#define MOST_HANGS 2

static void leave_unasked(block *asked)
{
    reply_fill(asked->replies, 0, asked->count, REPLY_UNASKED, 0);
    asked->nanoseconds = 0;
}

bool candidate_is_spent(const candidate *self)
{
    return self->crashes >= MOST_CRASHES || self->hangs >= MOST_HANGS;
}

void candidate_ask(candidate *self, block *asked)
{
    if (candidate_is_spent(self))
        leave_unasked(asked);
    else
        self->ask(self, asked);
}

void candidate_forgive(candidate *self)
{
    self->crashes = self->hangs = 0;
}

void candidate_close(candidate *self)
{
    if (self)
        self->close(self);
}

void candidate_count_end(candidate *self, reply_kind end)
{
    if (end == REPLY_HUNG)
        self->hangs++;
    else
        self->crashes++;
}

/* SPDX-License-Identifier: MIT */
#include "candidate_callback.h"

#include "exchange.h"

#include <stdlib.h>

#define CALLBACK_BLOCK 512

typedef struct {
    candidate common;
    candidate_callback *answer;
    void *context;
    double questions[EXCHANGE_HEAD + CALLBACK_BLOCK * CASE_NUMBERS_MAX];
    double answers[CALLBACK_BLOCK * EXCHANGE_ANSWER];
} callback;

/* A second time backwards. Where it gave up, the case is surely to blame. */
static candidate_end ask(candidate *common, block *asked, int first, int count)
{
    callback *self = (callback *)common;
    for (int pass = 0; pass < 2; pass++) {
        const exchange of = {asked->cases + first, count, .again = pass > 0};
        exchange_numbers(&of, (char *)self->questions);
        int answered = self->answer(self->context, self->questions, self->answers);
        if (answered < count)
            return (candidate_end){.kind = REPLY_CRASHED,
                                   .blamed = first + exchange_place(&of, answered),
                                   .surely = true};
        replies_from_numbers(&of, (const char *)self->answers, asked->replies + first);
    }
    return (candidate_end){.kind = REPLY_ANSWERED};
}

static void close_callback(candidate *common)
{
    free(common);
}

candidate *candidate_of_callback(candidate_callback *answer, void *context,
                                 const candidate_options *how, char *message)
{
    callback *self = calloc(1, sizeof *self);
    if (!self) {
        complain(message, "no memory");
        return NULL;
    }
    self->common = candidate_by_lines(how);
    self->common.block_cases = CALLBACK_BLOCK;
    self->common.is_program = false;
    self->common.is_quick = true;
    self->common.ask = ask;
    self->common.close = close_callback;
    self->answer = answer;
    self->context = context;
    return &self->common;
}

#include "tier_times.h"


#include <stdlib.h>
#include <string.h>

#define TIME_LIMIT 60 /* seconds for an answer, which always comes */

struct tier_times {
    candidate *tiers[SURE_TIERS][2]; /* opened when they are needed */
    rng order;
    block room;
};

tier_times *tier_times_new(void)
{
    return calloc(1, sizeof(tier_times));
}

void tier_times_free(tier_times *self)
{
    for (int i = 0; self && i < SURE_TIERS; i++) {
        candidate_close(self->tiers[i][0]);
        candidate_close(self->tiers[i][1]);
    }
    free(self);
}

/* As many as suit it. */
static void take_some(tier_times *self, const block *from, int first, int most)
{
    block *room = &self->room;
    int left = from->count - first;
    room->shape = from->shape;
    room->count = left < most ? left : most;
    memcpy(room->cases, from->cases + first, (size_t)room->count * sizeof *room->cases);
    shuffle_cases(room->cases, room->count, &self->order);
}

double tier_times_ask(tier_times *self, sure_tier tier, const block *cases, bool with_normals)
{
    const candidate_options how = {.inputs = INPUTS_DOUBLE, .time_limit = TIME_LIMIT};
    char message[CANDIDATE_MESSAGE];
    candidate **of = &self->tiers[tier][with_normals];
    if (!*of)
        *of = candidate_of_tier_functions(tier, with_normals, &how, message);
    if (!*of)
        return 0;
    double sum = 0;
    for (int first = 0; first < cases->count; first += self->room.count) {
        take_some(self, cases, first, (*of)->block_cases);
        candidate_ask(*of, &self->room);
        sum += self->room.nanoseconds;
    }
    return sum;
}

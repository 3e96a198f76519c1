#include "candidate.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TIER_BLOCK 512 /* all of it stays in the cache */

typedef struct {
    sure_status status;
    sure_hit hit;
    sure_vec3 normal;
} tier_answer;

typedef struct {
    candidate common;
    tier_answer first[TIER_BLOCK], second[TIER_BLOCK];
} tier_candidate;

/* What outputs hold before: a hit that writes nothing into it is told by it. */
static const sure_hit untouched = {
    .t = -0x1.a5a5a5a5a5a5ap+1000, .t_error = -1, .part = SURE_PART_WALL};

static bool is_untouched(const sure_hit *hit)
{
    return hit->t == untouched.t && hit->t_error == untouched.t_error &&
           hit->part == untouched.part;
}

static reply reply_of_tier(const tier_answer *from, const sure_case *question)
{
    reply given = {.status = from->status, .part = REPLY_NO_PART};
    if (from->status == SURE_HIT) {
        given.t = from->hit.t;
        given.part = (int)from->hit.part;
        given.has_normal = true;
        given.normal = from->normal;
        return given;
    }
    given.touched = !is_untouched(&from->hit);
    if (from->status == SURE_INVALID)
        given.field = sure_object_check(&question->ray, &question->object);
    return given;
}

static void pass(const tier_candidate *self, const block *asked, bool backwards,
                 tier_answer *answers)
{
    for (int n = 0; n < asked->count; n++) {
        int i = backwards ? asked->count - 1 - n : n;
        const sure_case *c = &asked->cases[i];
        tier_answer *to = &answers[i];
        to->hit = untouched;
        to->status = sure_object_hit(&c->ray, &c->object, self->common.tier, &to->hit);
        if (to->status == SURE_HIT)
            to->normal = sure_object_normal(&c->ray, &c->object, self->common.tier, &to->hit);
    }
}

static void compare(const tier_candidate *self, block *asked)
{
    for (int i = 0; i < asked->count; i++) {
        reply second = reply_of_tier(&self->second[i], &asked->cases[i]);
        asked->replies[i].changed = !reply_same(&asked->replies[i], &second);
        asked->replies[i].touched |= second.touched;
    }
}

static void ask(candidate *common, block *asked)
{
    tier_candidate *self = (tier_candidate *)common;
    pass(self, asked, false, self->first);
    for (int i = 0; i < asked->count; i++)
        asked->replies[i] = reply_of_tier(&self->first[i], &asked->cases[i]);
    if (asked->for_time) {
        pass(self, asked, true, self->second);
        compare(self, asked);
    }
    asked->nanoseconds = 0;
    asked->with_normals = false;
}

static void close_tier(candidate *common)
{
    free(common);
}

candidate *candidate_of_tier(sure_tier tier, const candidate_options *how, char *message)
{
    tier_candidate *self = calloc(1, sizeof *self);
    if (!self) {
        snprintf(message, CANDIDATE_MESSAGE, "no memory");
        return NULL;
    }
    bool single =
        how->inputs == INPUTS_AS_IT_TAKES ? tier == SURE_TIER_FLOAT32 : how->inputs == INPUTS_FLOAT;
    self->common = (candidate){.block_cases = TIER_BLOCK,
                               .is_tier = true,
                               .tier = tier,
                               .is_quick = true,
                               .ask = ask,
                               .close = close_tier};
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        self->common.answers[shape] = true;
        self->common.answers_in[shape] = single ? PRECISION_FLOAT : PRECISION_DOUBLE;
    }
    return &self->common;
}

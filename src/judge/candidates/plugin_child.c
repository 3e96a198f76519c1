/* SPDX-License-Identifier: MIT */
#include "plugin_functions.h"

#include "../../numbers/bits.h"
#include "../bench/instructions.h"

#include <surehit/candidate.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if defined __GLIBC__ && __GLIBC_PREREQ(2, 33)
#include <malloc.h>

/* Bytes that are allocated at the moment. */
static size_t memory_in_use(void)
{
    struct mallinfo2 now = mallinfo2();
    return now.uordblks + now.hblkhd;
}
#else
static size_t memory_in_use(void)
{
    return 0; /* not told: leaks stay unseen */
}
#endif

/* As the routines leave them. */
typedef struct {
    int statuses[PLUGIN_BLOCK];
    tier_output hits[PLUGIN_BLOCK]; /* or one of the smaller ones, one behind the other */
} outputs;
_Static_assert(sizeof(tier_output) >= sizeof(sure_candidate_hit), "room for a library's");

typedef struct {
    const plugin_source *from;
    const plugin_questions *questions;
    plugin_answers *answers;
    outputs passes[2];
    int pass, first, count; /* which is made, of which cases */
    struct {
        double building, asking;
    } took[2];
    function_table of;

    /* Of the questions: what is called, and bytes. */
    const functions *called;
    int ray_size, object_size, hit_size;
    const void *objects[PLUGIN_BLOCK]; /* numbers, or as they are built; NULL: it is refused */
} plugin;

/* Where the numbers of a case and its outputs lie. */

static const void *numbers_of(const plugin *self, int i)
{
    return (const char *)&self->questions->objects + i * self->object_size;
}

static void prepare(plugin *self)
{
    const plugin_questions *from = self->questions;
    bool in_float = from->in == PRECISION_FLOAT, interval = from->asks == QUERY_INTERVAL;
    int number_size = in_float ? sizeof(float) : sizeof(double);
    self->called = &self->of[from->asks][from->shape][from->in];
    self->ray_size = PLUGIN_RAY * number_size;
    self->object_size = (case_numbers(from->shape) - PLUGIN_RAY) * number_size;
    self->hit_size = !self->from->path ? in_float ? sizeof(tier_output_float) : sizeof(tier_output)
                     : in_float && interval ? sizeof(sure_candidate_interval_float)
                     : interval             ? sizeof(sure_candidate_interval)
                     : in_float             ? sizeof(sure_candidate_hit_float)
                                            : sizeof(sure_candidate_hit);
    for (int i = 0; i < from->count; i++)
        self->objects[i] = numbers_of(self, i);
}

/* Before, all bits of the outputs are set: every number is a NaN then, and a part is REPLY_NO_PART.
 * Of no more than are asked: a case that is made simple is asked a thousand times, alone. */
static void clear(const plugin *self, outputs *pass)
{
    const size_t count = (size_t)self->questions->count;
    memset(pass->statuses, 0xff, count * sizeof *pass->statuses);
    memset(pass->hits, 0xff, count * (size_t)self->hit_size);
}

/* `count` cases one by one, the first pass forwards from `first` and the second backwards to it.
 * What all of them need is found before: between the calls there is next to nothing, for it counts
 * as the routine's time. */
static void call_each(plugin *self, int pass, int first, int count)
{
    const plugin_questions *from = self->questions;
    plugin_answers *to = self->answers;
    one_routine *const routine = self->called->one;
    decision_routine *const decide = self->called->decide;
    const int step = pass == 0 ? 1 : -1, ray_step = step * self->ray_size;
    const int hit_step = step * self->hit_size;
    int i = pass == 0 ? first : first + count - 1, left = count;
    const char *ray = (const char *)&from->rays + i * self->ray_size;
    const void *const *object = self->objects + i;
    char *hit = (char *)self->passes[pass].hits + i * self->hit_size;
    int *status = self->passes[pass].statuses + i;
    unsigned progress = to->progress;
    for (; left > 0; left--, i += step) {
        to->at = i;
        *status = !*object ? SURE_CANDIDATE_INVALID
                  : decide ? decide(ray, *object)
                           : routine(ray, *object, hit);
        to->progress = ++progress;
        ray += ray_step;
        object += step;
        hit += hit_step;
        status += step;
    }
}

/* Cases first .. first + count - 1, at once where that is possible. */
static void call(plugin *self, int pass, int first, int count)
{
    const plugin_questions *from = self->questions;
    outputs *to = &self->passes[pass];
    if (!self->called->many) {
        call_each(self, pass, first, count);
        return;
    }
    self->answers->at = -1;
    self->called->many(count, (const char *)&from->rays + first * self->ray_size,
                       (const char *)&from->objects + first * self->object_size,
                       to->statuses + first, (char *)to->hits + first * self->hit_size);
    self->answers->progress++;
}

/* The first pass goes forwards, the second backwards; of many at once, half by half. */
static void call_all(void *context)
{
    plugin *self = context;
    int pass = self->pass, first = self->first, count = self->count,
        half = self->called->many && pass > 0 ? count / 2 : 0;
    call(self, pass, first + half, count - half);
    if (half > 0)
        call(self, pass, first, half);
}

static void build_all(void *context)
{
    plugin *self = context;
    for (int n = 0; n < self->count; n++) {
        int i = self->first + (self->pass == 0 ? n : self->count - 1 - n);
        self->answers->at = i;
        self->objects[i] = self->called->build(numbers_of(self, i));
        self->answers->progress++;
    }
}

static void free_all(plugin *self)
{
    for (int i = self->first; i < self->first + self->count; i++) {
        self->answers->at = i;
        if (self->objects[i])
            self->called->free(self->objects[i]);
        self->answers->progress++;
    }
}

/* What the outputs say. */

/* Of a float it is so much that is left. */
static bool is_untouched(double x)
{
    return bits_of(x) >> 29 == UINT64_MAX >> 29;
}

/* Both kinds; what a query has no output for is untouched. */
typedef struct {
    sure_candidate_hit hit;
    double t_leave;
} whole_output;

/* A tier whose t is untouched may have touched t_error. */
static sure_candidate_hit hit_of(const plugin *self, const void *at)
{
    const tier_output *tier = at;
    const tier_output_float *single_tier = at;
    const sure_candidate_hit_float *single = at;
    const bool in_float = self->questions->in == PRECISION_FLOAT;
    if (!self->from->path && in_float)
        return (sure_candidate_hit){
            single_tier->hit.t,
            (int)single_tier->hit.part,
            {single_tier->normal.x, single_tier->normal.y, single_tier->normal.z}};
    if (!self->from->path)
        return (sure_candidate_hit){is_untouched(tier->hit.t) ? tier->hit.t_error : tier->hit.t,
                                    (int)tier->hit.part,
                                    {tier->normal.x, tier->normal.y, tier->normal.z}};
    if (in_float)
        return (sure_candidate_hit){
            single->t, single->part, {single->normal[0], single->normal[1], single->normal[2]}};
    return *(const sure_candidate_hit *)at;
}

static whole_output output_of(const plugin *self, int pass, int i)
{
    const void *at = (const char *)self->passes[pass].hits + i * self->hit_size;
    const sure_candidate_interval *ends = at; /* a tier's begins so */
    const sure_candidate_interval_float *single = at;
    bool in_float = self->from->path && self->questions->in == PRECISION_FLOAT;
    whole_output all;
    memset(&all, 0xff, sizeof all);
    if (self->questions->asks != QUERY_INTERVAL) {
        all.hit = hit_of(self, at);
        return all;
    }
    all.hit.t = in_float ? (double)single->t_enter : ends->t_enter;
    all.t_leave = in_float ? (double)single->t_leave : ends->t_leave;
    return all;
}

static double number_of(double output)
{
    return is_untouched(output) ? NAN : output;
}

static reply reply_of_pass(const plugin *self, int pass, int i)
{
    int status = self->passes[pass].statuses[i];
    const whole_output said = output_of(self, pass, i);
    const double *n = said.hit.normal;
    bool has_normal = !is_untouched(n[0]) || !is_untouched(n[1]) || !is_untouched(n[2]);
    reply given = {.status = (sure_status)status, .part = REPLY_NO_PART};
    if (status == SURE_CANDIDATE_HIT) {
        given.t = number_of(said.hit.t);
        given.t_leave = number_of(said.t_leave);
        given.part = said.hit.part;
        given.has_normal = has_normal;
        given.normal = (sure_vec3){n[0], n[1], n[2]};
    } else if (status == SURE_CANDIDATE_MISS || status == SURE_CANDIDATE_INVALID) {
        given.touched = !is_untouched(said.hit.t) || !is_untouched(said.t_leave) || has_normal ||
                        said.hit.part != REPLY_NO_PART;
    } else {
        given.kind = REPLY_GARBAGE;
        snprintf(given.said, sizeof given.said, "status %d", status);
    }
    return given;
}

static void write_reply(const plugin *self, int i)
{
    reply *to = &self->answers->replies[i];
    *to = reply_of_pass(self, 0, i);
    if (self->questions->passes == 1)
        return;
    reply second = reply_of_pass(self, 1, i);
    to->changed = !reply_same(to, &second);
    to->touched |= second.touched;
}

/* Time. */

static double time_of(void (*run)(void *), plugin *self)
{
    return fmax(cost_of(run, self), 0);
}

/* Objects are built for each pass, so that building, too, is seen twice. */
static void make_pass(plugin *self, int pass, int first, int count)
{
    const bool builds = self->called->build;
    self->pass = pass;
    self->first = first;
    self->count = count;
    self->took[pass].building = builds ? time_of(build_all, self) : 0;
    self->took[pass].asking = time_of(call_all, self);
    if (builds)
        free_all(self);
}

/* It leaks who takes more each time; pools of a library's own are full after a few. */
#define LEAK_TRIES 8

static bool leaks(plugin *self, int i)
{
    for (int tries = 0; tries < LEAK_TRIES; tries++) {
        size_t before = memory_in_use();
        make_pass(self, 1, i, 1);
        if (memory_in_use() <= before)
            return false;
    }
    return true;
}

/* What a routine takes once, the first pass has taken: where the second takes and keeps more, the
 * cases are asked one by one for which of them it is. */
static void answer(plugin *self)
{
    int count = self->questions->count, last = self->questions->passes - 1;
    prepare(self);
    for (int pass = 0; pass <= last; pass++)
        clear(self, &self->passes[pass]);
    make_pass(self, 0, 0, count);
    size_t before = memory_in_use();
    if (last > 0)
        make_pass(self, last, 0, count);
    bool grows = memory_in_use() > before;
    self->answers->nanoseconds = fmin(self->took[0].asking, self->took[last].asking);
    self->answers->building = fmin(self->took[0].building, self->took[last].building);
    for (int i = 0; i < count; i++)
        write_reply(self, i);
    for (int i = 0; grows && i < count; i++)
        self->answers->replies[i].leaked = leaks(self, i);
}

_Noreturn void plugin_child(const plugin_source *from, const plugin_questions *questions,
                            plugin_answers *answers, int requests, int results)
{
    static plugin self;
    char byte = 0;
    self.from = from;
    self.questions = questions;
    self.answers = answers;
    dup2(STDERR_FILENO, STDOUT_FILENO); /* what the routine prints is not the judge's output */
    if (!functions_find(from, self.of, answers) || write(results, &byte, 1) != 1)
        _exit(EXIT_FAILURE);
    while (read(requests, &byte, 1) == 1) {
        answer(&self);
        if (write(results, &byte, 1) != 1)
            break;
    }
    _exit(EXIT_SUCCESS);
}

#include "plugin.h"

#include "../../numbers/bits.h"
#include "../bench/instructions.h"

#include <surehit/candidate.h>

#include <dlfcn.h>
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

/* Pointers to doubles, floats and outputs are handed on alike, as pointers to anything. Of each
 * precision; NULL where there is none. */
typedef int one_routine(const void *ray, const void *object, void *hit);
typedef void many_routine(int count, const void *rays, const void *objects, int *statuses,
                          void *hits);
typedef struct {
    one_routine *one[2];
    many_routine *many[2];
} functions;

/* The tiers as a library could have them: alone, or with the normal of a hit. */

typedef struct {
    sure_hit hit;
    sure_vec3 normal;
} tier_output;

/* The numbers of a case are ray and object as they lie in memory. */
_Static_assert(offsetof(sure_ray, t_max) == 7 * sizeof(double), "a ray's");

#define FUNCTIONS(shape, tier)                                                                     \
    static int shape##_##tier(const void *ray, const void *object, void *to)                       \
    {                                                                                              \
        return (int)sure_##shape##_hit_##tier(ray, object, &((tier_output *)to)->hit);             \
    }                                                                                              \
    static int shape##_##tier##_normal(const void *ray, const void *object, void *to)              \
    {                                                                                              \
        tier_output *of = to;                                                                      \
        int status = shape##_##tier(ray, object, to);                                              \
        if (status == SURE_HIT)                                                                    \
            of->normal = sure_##shape##_normal_##tier(ray, object, &of->hit);                      \
        return status;                                                                             \
    }

#define TIERS(X, shape)                                                                            \
    X(shape, float32) X(shape, textbook) X(shape, stable) X(shape, certain) X(shape, exact)

#define ALL_FUNCTIONS(shape, SHAPE) TIERS(FUNCTIONS, shape)
SURE_EACH_SHAPE(ALL_FUNCTIONS)

#define BOTH(shape, tier) {shape##_##tier, shape##_##tier##_normal},
#define ALL_TIERS(shape, SHAPE) {TIERS(BOTH, shape)},
static one_routine *const tiers[SURE_SHAPES][SURE_TIERS][2] = {SURE_EACH_SHAPE(ALL_TIERS)};

/* As the routines leave them; before, all of their bits are set: every number is a NaN then, and a
 * part is REPLY_NO_PART. */
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
    int pass; /* that is made */
    functions of[SURE_SHAPES];
    double clock; /* what reading it takes */

    /* Of the questions: what is called, and bytes. */
    one_routine *one;
    many_routine *many;
    int ray_size, object_size, hit_size;
} plugin;

/* dlsym's void * is a function's address, which ISO C can only be told byte by byte. */
static void find(void *library, sure_shape shape, const char *suffix, void *function)
{
    char name[64];
    snprintf(name, sizeof name, "sure_candidate_%s%s", sure_shape_name(shape), suffix);
    void *address = dlsym(library, name);
    memcpy(function, &address, sizeof address);
}

static bool find_functions(plugin *self, void *library)
{
    static const char *const suffixes[2][2] = {{"", "_float"}, {"_many", "_many_float"}};
    bool any = false;
    for (int i = 0; i < SURE_SHAPES * 2; i++) {
        functions *of = &self->of[i / 2];
        find(library, (sure_shape)(i / 2), suffixes[0][i % 2], &of->one[i % 2]);
        find(library, (sure_shape)(i / 2), suffixes[1][i % 2], &of->many[i % 2]);
        any |= self->answers->has[i / 2][i % 2] = of->one[i % 2] || of->many[i % 2];
    }
    return any;
}

static void take_words(void *library, const char *symbol, char *to, size_t room)
{
    const char *words = dlsym(library, symbol);
    snprintf(to, room, "%s", words ? words : "");
}

/* True, or false after a message. */
static bool load(plugin *self, const char *path)
{
    char *message = self->answers->message;
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return complain(message, "%s", dlerror());
    const int *version = dlsym(library, "sure_candidate_version");
    if (!version)
        return complain(message, "%s: no symbol sure_candidate_version", path);
    if (*version != SURE_CANDIDATE_VERSION)
        return complain(message, "%s: sure_candidate_version is %d, expected %d", path, *version,
                        SURE_CANDIDATE_VERSION);
    plugin_answers *to = self->answers;
    take_words(library, "sure_candidate_entry", to->entry, sizeof to->entry);
    take_words(library, "sure_candidate_name", to->who.name, sizeof to->who.name);
    take_words(library, "sure_candidate_release", to->who.version, sizeof to->who.version);
    take_words(library, "sure_candidate_build", to->who.build, sizeof to->who.build);
    return find_functions(self, library) ||
           complain(message, "%s: no symbol sure_candidate_<shape>", path);
}

static bool find_source(plugin *self)
{
    const plugin_source *from = self->from;
    if (from->path)
        return load(self, from->path);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        self->of[shape].one[PRECISION_DOUBLE] = tiers[shape][from->tier][from->with_normals];
        self->answers->has[shape][PRECISION_DOUBLE] = true;
        self->answers->has[shape][PRECISION_FLOAT] = true; /* in doubles, too */
    }
    return true;
}

/* Where the numbers of a case and its outputs lie. */

static void prepare(plugin *self)
{
    const plugin_questions *from = self->questions;
    bool in_float = from->in == PRECISION_FLOAT;
    int number_size = in_float ? sizeof(float) : sizeof(double);
    self->one = self->of[from->shape].one[from->in];
    self->many = self->of[from->shape].many[from->in];
    self->ray_size = PLUGIN_RAY * number_size;
    self->object_size = (case_numbers(from->shape) - PLUGIN_RAY) * number_size;
    self->hit_size = !self->from->path ? sizeof(tier_output)
                     : in_float        ? sizeof(sure_candidate_hit_float)
                                       : sizeof(sure_candidate_hit);
}

/* `count` cases one by one, the first pass forwards from `first` and the second backwards to it.
 * What all of them need is found before: between the calls there is next to nothing, for it counts
 * as the routine's time. */
static void call_each(plugin *self, int pass, int first, int count)
{
    const plugin_questions *from = self->questions;
    plugin_answers *to = self->answers;
    one_routine *const routine = self->one;
    const int step = pass == 0 ? 1 : -1, ray_step = step * self->ray_size;
    const int object_step = step * self->object_size, hit_step = step * self->hit_size;
    int i = pass == 0 ? first : first + count - 1, left = count;
    const char *ray = (const char *)&from->rays + i * self->ray_size;
    const char *object = (const char *)&from->objects + i * self->object_size;
    char *hit = (char *)self->passes[pass].hits + i * self->hit_size;
    int *status = self->passes[pass].statuses + i;
    unsigned progress = to->progress;
    for (; left > 0; left--, i += step) {
        to->at = i;
        *status = routine(ray, object, hit);
        to->progress = ++progress;
        ray += ray_step;
        object += object_step;
        hit += hit_step;
        status += step;
    }
}

/* Cases first .. first + count - 1, at once where that is possible. */
static void call(plugin *self, int pass, int first, int count)
{
    const plugin_questions *from = self->questions;
    outputs *to = &self->passes[pass];
    if (!self->many) {
        call_each(self, pass, first, count);
        return;
    }
    self->answers->at = -1;
    self->many(count, (const char *)&from->rays + first * self->ray_size,
               (const char *)&from->objects + first * self->object_size, to->statuses + first,
               (char *)to->hits + first * self->hit_size);
    self->answers->progress++;
}

/* The first pass goes forwards, the second backwards; of many at once, half by half. */
static void call_all(void *context)
{
    plugin *self = context;
    int pass = self->pass, count = self->questions->count,
        half = self->many && pass > 0 ? count / 2 : 0;
    call(self, pass, half, count - half);
    if (half > 0)
        call(self, pass, 0, half);
}

/* What the outputs say. */

/* Of a float it is so much that is left. */
static bool is_untouched(double x)
{
    return bits_of(x) >> 29 == UINT64_MAX >> 29;
}

/* A tier whose t is untouched may have touched t_error. */
static sure_candidate_hit output_of(const plugin *self, int pass, int i)
{
    const void *at = (const char *)self->passes[pass].hits + i * self->hit_size;
    const tier_output *tier = at;
    const sure_candidate_hit_float *single = at;
    if (!self->from->path)
        return (sure_candidate_hit){is_untouched(tier->hit.t) ? tier->hit.t_error : tier->hit.t,
                                    (int)tier->hit.part,
                                    {tier->normal.x, tier->normal.y, tier->normal.z}};
    if (self->questions->in == PRECISION_FLOAT)
        return (sure_candidate_hit){
            single->t, single->part, {single->normal[0], single->normal[1], single->normal[2]}};
    return *(const sure_candidate_hit *)at;
}

static reply reply_of_pass(const plugin *self, int pass, int i)
{
    int status = self->passes[pass].statuses[i];
    sure_candidate_hit hit = output_of(self, pass, i);
    const double *n = hit.normal;
    bool has_t = !is_untouched(hit.t);
    bool has_normal = !is_untouched(n[0]) || !is_untouched(n[1]) || !is_untouched(n[2]);
    reply given = {.status = (sure_status)status, .part = REPLY_NO_PART};
    if (status == SURE_CANDIDATE_HIT) {
        given.t = has_t ? hit.t : NAN;
        given.part = hit.part;
        given.has_normal = has_normal;
        given.normal = (sure_vec3){n[0], n[1], n[2]};
    } else if (status == SURE_CANDIDATE_MISS || status == SURE_CANDIDATE_INVALID) {
        given.touched = has_t || has_normal || hit.part != REPLY_NO_PART;
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

static void do_nothing(void *context)
{
    (void)context;
}

/* What measuring takes, the least of several times; a count repeats. */
static double time_of_clock(void)
{
    double least = INFINITY;
    for (int i = instructions_counting() ? 99 : 0; i < 100; i++)
        least = fmin(least, cost_of(do_nothing, NULL));
    return least;
}

static double time_pass(plugin *self, int pass)
{
    memset(&self->passes[pass], 0xff, sizeof self->passes[pass]);
    self->pass = pass;
    return fmax(cost_of(call_all, self) - self->clock, 0);
}

/* What a routine takes once, the first pass has taken: what the second takes and keeps is lost, and
 * the cases are asked one by one for which of them it is. */
static void answer(plugin *self)
{
    int count = self->questions->count;
    prepare(self);
    double once = time_pass(self, 0), again = once;
    size_t before = memory_in_use();
    if (self->questions->passes > 1)
        again = time_pass(self, 1);
    bool leaks = memory_in_use() > before;
    self->answers->nanoseconds = once < again ? once : again;
    for (int i = 0; i < count; i++)
        write_reply(self, i);
    for (int i = 0; leaks && i < count; i++) {
        before = memory_in_use();
        call(self, 1, i, 1);
        self->answers->replies[i].leaked = memory_in_use() > before;
    }
}

_Noreturn void plugin_child(const plugin_source *from, const plugin_questions *questions,
                            plugin_answers *answers, int requests, int results)
{
    static plugin self;
    char byte = 0;
    self.from = from;
    self.questions = questions;
    self.answers = answers;
    self.clock = time_of_clock();
    dup2(STDERR_FILENO, STDOUT_FILENO); /* what the routine prints is not the judge's output */
    if (!find_source(&self) || write(results, &byte, 1) != 1)
        _exit(EXIT_FAILURE);
    while (read(requests, &byte, 1) == 1) {
        answer(&self);
        if (write(results, &byte, 1) != 1)
            break;
    }
    _exit(EXIT_SUCCESS);
}

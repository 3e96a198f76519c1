#define _DEFAULT_SOURCE /* dlopen, mallinfo2 */

#include "plugin.h"

#include "../../support/cpu_time.h"
#include "tier_functions.h"

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

/* The functions of one shape and precision; NULL where there is none. */
typedef int function_double(const double *, const double *, sure_candidate_hit *);
typedef int function_float(const float *, const float *, sure_candidate_hit_float *);
typedef void many_double(int, const double *, const double *, int *, sure_candidate_hit *);
typedef void many_float(int, const float *, const float *, int *, sure_candidate_hit_float *);

typedef struct {
    function_double *one_double;
    function_float *one_float;
    tier_function *one_tier;
    many_double *many;
    many_float *many_of_float;
} functions;

/* As the routines leave them; before, all of their bits are set: every number is a NaN then, and a
 * part is REPLY_NO_PART. */
typedef struct {
    int statuses[PLUGIN_BLOCK];
    union {
        sure_candidate_hit of_double[PLUGIN_BLOCK];
        sure_candidate_hit_float of_float[PLUGIN_BLOCK];
        tier_output of_tier[PLUGIN_BLOCK];
    } hits;
} outputs;

typedef struct {
    const plugin_source *from;
    const plugin_questions *questions;
    plugin_answers *answers;
    outputs passes[2];
    functions of[SURE_SHAPES];
    double clock; /* what reading it takes */
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
    bool any = false;
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        functions *of = &self->of[shape];
        find(library, (sure_shape)shape, "", &of->one_double);
        find(library, (sure_shape)shape, "_float", &of->one_float);
        find(library, (sure_shape)shape, "_many", &of->many);
        find(library, (sure_shape)shape, "_many_float", &of->many_of_float);
        bool *has = self->answers->has[shape];
        has[PRECISION_DOUBLE] = of->one_double || of->many;
        has[PRECISION_FLOAT] = of->one_float || of->many_of_float;
        any = any || has[PRECISION_DOUBLE] || has[PRECISION_FLOAT];
    }
    return any;
}

/* True, or false after a message. */
static bool load(plugin *self, const char *path)
{
    char *message = self->answers->message;
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        snprintf(message, CANDIDATE_MESSAGE, "%s", dlerror());
        return false;
    }
    const int *version = dlsym(library, "sure_candidate_version");
    if (!version) {
        snprintf(message, CANDIDATE_MESSAGE, "%s: no symbol sure_candidate_version", path);
        return false;
    }
    if (*version != SURE_CANDIDATE_VERSION) {
        snprintf(message, CANDIDATE_MESSAGE, "%s: sure_candidate_version is %d, expected %d", path,
                 *version, SURE_CANDIDATE_VERSION);
        return false;
    }
    if (!find_functions(self, library)) {
        snprintf(message, CANDIDATE_MESSAGE, "%s: no symbol sure_candidate_<shape>", path);
        return false;
    }
    return true;
}

static bool find_source(plugin *self)
{
    const plugin_source *from = self->from;
    if (from->path)
        return load(self, from->path);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        self->of[shape].one_tier =
            tier_function_of(from->tier, (sure_shape)shape, from->with_normals);
        self->answers->has[shape][PRECISION_DOUBLE] = true;
        self->answers->has[shape][PRECISION_FLOAT] = true; /* in doubles, too */
    }
    return true;
}

/* Where the numbers of a case and its outputs lie. */

static int object_numbers(const plugin *self)
{
    return case_numbers(self->questions->shape) - PLUGIN_RAY;
}

static size_t ray_at(int i)
{
    return (size_t)i * PLUGIN_RAY;
}

static size_t object_at(const plugin *self, int i)
{
    return (size_t)(i * object_numbers(self));
}

static bool asks_many(const plugin *self)
{
    const functions *of = &self->of[self->questions->shape];
    return self->questions->in == PRECISION_FLOAT ? of->many_of_float != NULL : of->many != NULL;
}

/* Cases first .. first + count - 1 at once. */
static void call_many(plugin *self, int pass, int first, int count)
{
    const plugin_questions *from = self->questions;
    const functions *of = &self->of[from->shape];
    outputs *to = &self->passes[pass];
    size_t ray = ray_at(first), object = object_at(self, first);
    self->answers->at = -1;
    if (from->in == PRECISION_FLOAT)
        of->many_of_float(count, from->rays.of_float + ray, from->objects.of_float + object,
                          to->statuses + first, to->hits.of_float + first);
    else
        of->many(count, from->rays.of_double + ray, from->objects.of_double + object,
                 to->statuses + first, to->hits.of_double + first);
    self->answers->progress++;
}

/* `count` cases one by one, the first pass forwards from `first` and the second backwards to it.
 * What all of them need is found before: between the calls there is next to nothing, for it counts
 * as the routine's time. */
#define CALL_EACH(kind, real, function, output)                                                    \
    static void call_each_##kind(plugin *self, int pass, int first, int count)                     \
    {                                                                                              \
        const int step = pass == 0 ? 1 : -1, numbers = step * object_numbers(self);                \
        int i = pass == 0 ? first : first + count - 1, left = count;                               \
        plugin_answers *to = self->answers;                                                        \
        function *const routine = self->of[self->questions->shape].one_##kind;                     \
        const real *ray = self->questions->rays.of_##real + ray_at(i);                             \
        const real *object = self->questions->objects.of_##real + object_at(self, i);              \
        int *status = self->passes[pass].statuses + i;                                             \
        output *hit = self->passes[pass].hits.of_##kind + i;                                       \
        unsigned progress = to->progress;                                                          \
        for (; left > 0; left--, i += step, status += step, hit += step) {                         \
            to->at = i;                                                                            \
            *status = (int)routine(ray, object, hit);                                              \
            to->progress = ++progress;                                                             \
            ray += step * PLUGIN_RAY;                                                              \
            object += numbers;                                                                     \
        }                                                                                          \
    }
CALL_EACH(double, double, function_double, sure_candidate_hit)
CALL_EACH(float, float, function_float, sure_candidate_hit_float)
CALL_EACH(tier, double, tier_function, tier_output)

static void call_each(plugin *self, int pass, int first, int count)
{
    if (self->from->path == NULL)
        call_each_tier(self, pass, first, count);
    else if (self->questions->in == PRECISION_FLOAT)
        call_each_float(self, pass, first, count);
    else
        call_each_double(self, pass, first, count);
}

static void call(plugin *self, int pass, int i)
{
    if (asks_many(self))
        call_many(self, pass, i, 1);
    else
        call_each(self, pass, i, 1);
}

/* The first pass goes forwards, the second backwards; of many at once, half by half. */
static void call_all(plugin *self, int pass)
{
    int first = self->questions->first, count = self->questions->count, half = count / 2;
    if (asks_many(self) && pass == 0) {
        call_many(self, pass, first, count);
    } else if (asks_many(self)) {
        call_many(self, pass, first + half, count - half);
        if (half > 0)
            call_many(self, pass, first, half);
    } else {
        call_each(self, pass, first, count);
    }
}

/* What the outputs say. */

static bool is_untouched(const void *output, size_t size)
{
    const unsigned char *byte = output;
    while (size > 0 && *byte == 0xff)
        byte++, size--;
    return size == 0;
}

/* As on a hit, and whether anything was written. */
#define READ_OUTPUT(output)                                                                        \
    static reply read_##output(const output *from)                                                 \
    {                                                                                              \
        bool t_written = !is_untouched(&from->t, sizeof from->t);                                  \
        reply read = {.t = t_written ? from->t : NAN, .part = from->part};                         \
        read.normal = (sure_vec3){from->normal[0], from->normal[1], from->normal[2]};              \
        read.has_normal = !is_untouched(from->normal, sizeof from->normal);                        \
        read.touched = t_written || read.has_normal || read.part != REPLY_NO_PART;                 \
        return read;                                                                               \
    }
READ_OUTPUT(sure_candidate_hit)
READ_OUTPUT(sure_candidate_hit_float)

static reply read_tier(const tier_output *from, bool with_normals)
{
    return (reply){.t = from->hit.t,
                   .part = (int)from->hit.part,
                   .has_normal = with_normals,
                   .normal = from->normal,
                   .touched = !is_untouched(&from->hit, sizeof from->hit)};
}

static reply reply_of_pass(const plugin *self, int pass, int i)
{
    const outputs *from = &self->passes[pass];
    int status = from->statuses[i];
    if (status != SURE_CANDIDATE_MISS && status != SURE_CANDIDATE_HIT &&
        status != SURE_CANDIDATE_INVALID)
        return (reply){.kind = REPLY_GARBAGE, .part = REPLY_NO_PART};
    reply given = !self->from->path ? read_tier(&from->hits.of_tier[i], self->from->with_normals)
                  : self->questions->in == PRECISION_FLOAT
                      ? read_sure_candidate_hit_float(&from->hits.of_float[i])
                      : read_sure_candidate_hit(&from->hits.of_double[i]);
    if (status != SURE_CANDIDATE_HIT)
        return (reply){
            .status = (sure_status)status, .part = REPLY_NO_PART, .touched = given.touched};
    given.status = SURE_HIT;
    given.touched = false;
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

/* Between two readings of the clock there is one reading's time, the least of several. */
static double time_of_clock(void)
{
    double least = INFINITY;
    for (int i = 0; i < 100; i++) {
        double start = cpu_time();
        least = fmin(least, cpu_time() - start);
    }
    return least;
}

static double time_pass(plugin *self, int pass)
{
    memset(&self->passes[pass], 0xff, sizeof self->passes[pass]);
    double start = cpu_time();
    call_all(self, pass);
    return fmax(cpu_time() - start - self->clock, 0);
}

/* What a routine takes once, the first pass has taken: what the second takes and keeps is lost, and
 * the cases are asked one by one for which of them it is. */
static void answer(plugin *self)
{
    int first = self->questions->first, count = self->questions->count;
    double once = time_pass(self, 0), again = once;
    size_t before = memory_in_use();
    if (self->questions->passes > 1)
        again = time_pass(self, 1);
    bool leaks = memory_in_use() > before;
    self->answers->nanoseconds = once < again ? once : again;
    for (int i = first; i < first + count; i++)
        write_reply(self, i);
    for (int i = first; leaks && i < first + count; i++) {
        before = memory_in_use();
        call(self, 1, i);
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

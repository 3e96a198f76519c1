#define _DEFAULT_SOURCE /* dlopen, mallinfo2 */

#include "plugin.h"

#include "../../support/cpu_time.h"

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

typedef struct {
    const plugin_source *from;
    const plugin_questions *questions;
    plugin_answers *answers;
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
    }
    return true;
}

/* Where the numbers of a case and its outputs lie. */

static int object_numbers(const plugin *self)
{
    return case_numbers(self->questions->shape) - PLUGIN_RAY;
}

static const double *ray_of(const plugin *self, int i)
{
    return self->questions->rays + (size_t)i * PLUGIN_RAY;
}

static const double *object_of(const plugin *self, int i)
{
    return self->questions->objects + (size_t)(i * object_numbers(self));
}

static const float *float_ray_of(const plugin *self, int i)
{
    return self->questions->rays_float + (size_t)i * PLUGIN_RAY;
}

static const float *float_object_of(const plugin *self, int i)
{
    return self->questions->objects_float + (size_t)(i * object_numbers(self));
}

static bool asks_many(const plugin *self)
{
    const functions *of = &self->of[self->questions->shape];
    return self->questions->in == PRECISION_FLOAT ? of->many_of_float != NULL : of->many != NULL;
}

/* Cases first .. first + count - 1 at once. */
static void call_many(const plugin *self, int pass, int first, int count)
{
    const functions *of = &self->of[self->questions->shape];
    int *statuses = self->answers->statuses[pass] + first;
    self->answers->at = -1;
    if (self->questions->in == PRECISION_FLOAT)
        of->many_of_float(count, float_ray_of(self, first), float_object_of(self, first), statuses,
                          self->answers->hits[pass].of_float + first);
    else
        of->many(count, ray_of(self, first), object_of(self, first), statuses,
                 self->answers->hits[pass].of_double + first);
    self->answers->progress++;
}

/* `count` cases one by one, the first pass forwards from `first` and the second backwards to it.
 * What all of them need is found before: between the calls there is next to nothing, for it counts
 * as the routine's time. */
#define CALL_EACH(kind, real, function, output, ray_at, object_at)                                 \
    static void call_each_##kind(const plugin *self, int pass, int first, int count)               \
    {                                                                                              \
        const int step = pass == 0 ? 1 : -1, numbers = step * object_numbers(self);                \
        int i = pass == 0 ? first : first + count - 1, left = count;                               \
        plugin_answers *to = self->answers;                                                        \
        function *const routine = self->of[self->questions->shape].one_##kind;                     \
        const real *ray = ray_at(self, i), *object = object_at(self, i);                           \
        int *status = to->statuses[pass] + i;                                                      \
        output *hit = to->hits[pass].of_##kind + i;                                                \
        unsigned progress = to->progress;                                                          \
        for (; left > 0; left--, i += step, status += step, hit += step) {                         \
            to->at = i;                                                                            \
            *status = (int)routine(ray, object, hit);                                              \
            to->progress = ++progress;                                                             \
            ray += step * PLUGIN_RAY;                                                              \
            object += numbers;                                                                     \
        }                                                                                          \
    }
CALL_EACH(double, double, function_double, sure_candidate_hit, ray_of, object_of)
CALL_EACH(float, float, function_float, sure_candidate_hit_float, float_ray_of, float_object_of)
CALL_EACH(tier, double, tier_function, tier_output, ray_of, object_of)

static void call_each(const plugin *self, int pass, int first, int count)
{
    if (self->from->path == NULL)
        call_each_tier(self, pass, first, count);
    else if (self->questions->in == PRECISION_FLOAT)
        call_each_float(self, pass, first, count);
    else
        call_each_double(self, pass, first, count);
}

static void call(const plugin *self, int pass, int i)
{
    if (asks_many(self))
        call_many(self, pass, i, 1);
    else
        call_each(self, pass, i, 1);
}

/* The first pass goes forwards, the second backwards; of many at once, half by half. */
static void call_all(const plugin *self, int pass)
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

static void fill_hit(sure_candidate_hit *hit)
{
    const uint64_t untouched = PLUGIN_UNTOUCHED;
    double nothing;
    memcpy(&nothing, &untouched, sizeof nothing);
    *hit = (sure_candidate_hit){nothing, REPLY_NO_PART, {nothing, nothing, nothing}};
}

static void fill_hit_float(sure_candidate_hit_float *hit)
{
    const uint32_t untouched = PLUGIN_UNTOUCHED_FLOAT;
    float nothing;
    memcpy(&nothing, &untouched, sizeof nothing);
    *hit = (sure_candidate_hit_float){nothing, REPLY_NO_PART, {nothing, nothing, nothing}};
}

static void fill_outputs(const plugin *self, int pass)
{
    plugin_answers *to = self->answers;
    int first = self->questions->first;
    for (int i = first; i < first + self->questions->count; i++) {
        to->statuses[pass][i] = PLUGIN_NO_STATUS;
        to->leaked[i] = false;
        if (!self->from->path)
            to->hits[pass].of_tier[i] = (tier_output){.hit = {.t = 0}};
        else if (self->questions->in == PRECISION_FLOAT)
            fill_hit_float(&to->hits[pass].of_float[i]);
        else
            fill_hit(&to->hits[pass].of_double[i]);
    }
}

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

static double time_pass(const plugin *self, int pass)
{
    fill_outputs(self, pass);
    double start = cpu_time();
    call_all(self, pass);
    return fmax(cpu_time() - start - self->clock, 0);
}

/* Cases one by one: for which of them does memory stay taken? Their outputs are those of the second
 * pass once more. */
static void find_leaks(const plugin *self)
{
    int first = self->questions->first;
    for (int i = first; i < first + self->questions->count; i++) {
        size_t before = memory_in_use();
        call(self, 1, i);
        self->answers->leaked[i] = memory_in_use() > before;
    }
}

/* What a routine takes once, the first pass has taken: what the second takes and keeps is lost. */
static void answer(const plugin *self)
{
    double once = time_pass(self, 0);
    size_t before = memory_in_use();
    double again = time_pass(self, 1);
    if (memory_in_use() > before)
        find_leaks(self);
    self->answers->nanoseconds = once < again ? once : again;
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

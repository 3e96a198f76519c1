#define _DEFAULT_SOURCE /* dlopen, mallinfo2 */

#include "plugin.h"

#include "cpu_time.h"

#include <dlfcn.h>
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
typedef int one_double(const double *, const double *, sure_candidate_hit *);
typedef int one_float(const float *, const float *, sure_candidate_hit_float *);
typedef void many_double(int, const double *, const double *, int *, sure_candidate_hit *);
typedef void many_float(int, const float *, const float *, int *, sure_candidate_hit_float *);

typedef struct {
    one_double *one;
    one_float *one_of_float;
    many_double *many;
    many_float *many_of_float;
} functions;

typedef struct {
    const plugin_questions *questions;
    plugin_answers *answers;
    functions of[SURE_SHAPES];
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
        find(library, (sure_shape)shape, "", &of->one);
        find(library, (sure_shape)shape, "_float", &of->one_of_float);
        find(library, (sure_shape)shape, "_many", &of->many);
        find(library, (sure_shape)shape, "_many_float", &of->many_of_float);
        bool *has = self->answers->has[shape];
        has[PRECISION_DOUBLE] = of->one || of->many;
        has[PRECISION_FLOAT] = of->one_of_float || of->many_of_float;
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

static void call_one(const plugin *self, int pass, int i)
{
    const functions *of = &self->of[self->questions->shape];
    self->answers->at = i;
    if (self->questions->in == PRECISION_FLOAT)
        self->answers->statuses[pass][i] =
            of->one_of_float(float_ray_of(self, i), float_object_of(self, i),
                             &self->answers->hits[pass].of_float[i]);
    else
        self->answers->statuses[pass][i] =
            of->one(ray_of(self, i), object_of(self, i), &self->answers->hits[pass].of_double[i]);
    self->answers->progress++;
}

static void call(const plugin *self, int pass, int i)
{
    if (asks_many(self))
        call_many(self, pass, i, 1);
    else
        call_one(self, pass, i);
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
        for (int i = 0; i < count; i++)
            call_one(self, pass, pass == 0 ? first + i : first + count - 1 - i);
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
        if (self->questions->in == PRECISION_FLOAT)
            fill_hit_float(&to->hits[pass].of_float[i]);
        else
            fill_hit(&to->hits[pass].of_double[i]);
    }
}

static double time_pass(const plugin *self, int pass)
{
    fill_outputs(self, pass);
    double start = cpu_time();
    call_all(self, pass);
    return cpu_time() - start;
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

_Noreturn void plugin_child(const char *path, const plugin_questions *questions,
                            plugin_answers *answers, int requests, int results)
{
    static plugin self;
    char byte = 0;
    self.questions = questions;
    self.answers = answers;
    dup2(STDERR_FILENO, STDOUT_FILENO); /* what the routine prints is not the judge's output */
    if (!load(&self, path) || write(results, &byte, 1) != 1)
        _exit(EXIT_FAILURE);
    while (read(requests, &byte, 1) == 1) {
        answer(&self);
        if (write(results, &byte, 1) != 1)
            break;
    }
    _exit(EXIT_SUCCESS);
}

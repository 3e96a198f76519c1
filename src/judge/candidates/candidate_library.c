#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */

#include "candidate.h"
#include "child.h"
#include "plugin.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

typedef struct {
    candidate common;
    plugin_source from;
    char path[4096]; /* room for one */
    double time_limit;
    plugin_questions *questions;
    plugin_answers *answers;
    child process; /* the last one */
} library;

/* The child. */

static void *share(size_t size)
{
    void *at = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return at == MAP_FAILED ? NULL : at;
}

static void live_as_child(const void *context, int requests, int results)
{
    const library *self = context;
    mprotect(self->questions, sizeof *self->questions, PROT_READ);
    plugin_child(&self->from, self->questions, self->answers, requests, results);
}

static bool start(library *self)
{
    self->answers->at = -1;
    return child_start(&self->process, live_as_child, self);
}

/* Waits for its byte. It hangs when no call comes back for as long as the time limit. */
static reply_kind wait_for_result(library *self)
{
    for (;;) {
        unsigned before = self->answers->progress;
        struct pollfd result = {.fd = self->process.output, .events = POLLIN};
        int ready = poll(&result, 1, (int)(self->time_limit * 1000) + 1);
        char byte;
        if (ready > 0) {
            if (read(self->process.output, &byte, 1) == 1)
                return REPLY_ANSWERED;
            child_bury(&self->process); /* it closed its end, and is ending by itself */
            return REPLY_CRASHED;
        }
        if (ready == 0 && self->answers->progress == before) {
            child_stop(&self->process);
            return REPLY_HUNG;
        }
    }
}

static const char *name_of(const library *self)
{
    return self->from.path ? self->from.path : sure_tier_name(self->from.tier);
}

/* The message of a child that could not load the library, or how it ended before it had. */
static void explain(const library *self, char *message)
{
    if (self->answers->message[0] != '\0') {
        memcpy(message, self->answers->message, CANDIDATE_MESSAGE);
    } else {
        reply end = {.kind = REPLY_CRASHED, .ended = self->process.ended};
        char text[CASE_LINE_MAX];
        reply_print(&end, text);
        snprintf(message, CANDIDATE_MESSAGE, "%s: while it was loaded, %.256s", name_of(self),
                 text);
    }
}

static bool is_loaded(library *self, char *message)
{
    self->answers->message[0] = '\0';
    if (!start(self)) {
        snprintf(message, CANDIDATE_MESSAGE, "no process for it: %s", strerror(errno));
        return false;
    }
    reply_kind result = wait_for_result(self);
    if (result == REPLY_HUNG)
        snprintf(message, CANDIDATE_MESSAGE, "%s: it takes too long to be loaded", name_of(self));
    else if (result != REPLY_ANSWERED)
        explain(self, message);
    return result == REPLY_ANSWERED;
}

/* Questions and answers. */

static void write_question(plugin_questions *to, const sure_case *question, int i)
{
    double numbers[CASE_NUMBERS_MAX];
    int fields = case_numbers(question->object.shape) - PLUGIN_RAY;
    size_t ray = (size_t)i * PLUGIN_RAY, object = (size_t)(i * fields);
    case_to_numbers(question, numbers);
    memcpy(to->rays + ray, numbers, PLUGIN_RAY * sizeof *numbers);
    memcpy(to->objects + object, numbers + PLUGIN_RAY, (size_t)fields * sizeof *numbers);
    if (to->in == PRECISION_DOUBLE)
        return;
    for (int n = 0; n < PLUGIN_RAY; n++)
        to->rays_float[ray + (size_t)n] = (float)numbers[n];
    for (int n = 0; n < fields; n++)
        to->objects_float[object + (size_t)n] = (float)numbers[PLUGIN_RAY + n];
}

static bool is_untouched(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits == PLUGIN_UNTOUCHED;
}

static bool is_untouched_float(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits == PLUGIN_UNTOUCHED_FLOAT;
}

/* An output as double, and whether it was written. */
typedef struct {
    double t, normal[3];
    int part;
    bool t_written, normal_written;
} output;

static output output_of_double(const sure_candidate_hit *hit)
{
    output read = {.t = hit->t, .part = hit->part, .t_written = !is_untouched(hit->t)};
    for (int i = 0; i < 3; i++) {
        read.normal[i] = hit->normal[i];
        read.normal_written |= !is_untouched(hit->normal[i]);
    }
    return read;
}

static output output_of_float(const sure_candidate_hit_float *hit)
{
    output read = {.t = hit->t, .part = hit->part, .t_written = !is_untouched_float(hit->t)};
    for (int i = 0; i < 3; i++) {
        read.normal[i] = hit->normal[i];
        read.normal_written |= !is_untouched_float(hit->normal[i]);
    }
    return read;
}

static reply reply_of_pass(const library *self, int pass, int i)
{
    const plugin_answers *from = self->answers;
    int status = from->statuses[pass][i];
    output read = self->questions->in == PRECISION_FLOAT
                      ? output_of_float(&from->hits[pass].of_float[i])
                      : output_of_double(&from->hits[pass].of_double[i]);
    reply given = {.part = REPLY_NO_PART};
    if (status != SURE_CANDIDATE_MISS && status != SURE_CANDIDATE_HIT &&
        status != SURE_CANDIDATE_INVALID) {
        given.kind = REPLY_GARBAGE;
        return given;
    }
    given.status = status == SURE_CANDIDATE_HIT    ? SURE_HIT
                   : status == SURE_CANDIDATE_MISS ? SURE_MISS
                                                   : SURE_INVALID;
    if (status == SURE_CANDIDATE_HIT) {
        given.t = read.t;
        given.part = read.part;
        given.has_normal = read.normal_written;
        given.normal = (sure_vec3){read.normal[0], read.normal[1], read.normal[2]};
    } else {
        given.touched = read.t_written || read.normal_written || read.part != REPLY_NO_PART;
    }
    return given;
}

static void read_replies(const library *self, reply *replies, int first, int count)
{
    for (int i = first; i < first + count; i++) {
        reply second = reply_of_pass(self, 1, i);
        replies[i] = reply_of_pass(self, 0, i);
        replies[i].changed = !reply_same(&replies[i], &second);
        replies[i].touched |= second.touched;
        replies[i].leaked = self->answers->leaked[i];
    }
}

/* Asking. */

static reply_kind ask_child(library *self, int first, int count)
{
    char byte = 0;
    char message[CANDIDATE_MESSAGE];
    if (self->process.id == 0 && !is_loaded(self, message))
        return REPLY_CRASHED;
    self->questions->first = first;
    self->questions->count = count;
    if (write(self->process.input, &byte, 1) != 1)
        self->answers->at = -1;
    return wait_for_result(self);
}

static void ask_part(library *self, reply *replies, int first, int count);

/* The child ended in one of these cases: in `at`, if it is one of them; else the halves are asked
 * again. */
static void narrow_down(library *self, reply *replies, int first, int count, reply_kind end)
{
    int at = count == 1 ? first : self->answers->at;
    if (at < first || at >= first + count) {
        int ends = self->common.crashes + self->common.hangs, ended = self->process.ended;
        ask_part(self, replies, first, count / 2);
        ask_part(self, replies, first + count / 2, count - count / 2);
        if (self->common.crashes + self->common.hangs > ends)
            return;
        reply_fill(replies, first, 1, end, ended); /* only all of them together do it */
        candidate_count_end(&self->common, end);
        return;
    }
    candidate_count_end(&self->common, end);
    int ended = self->process.ended;
    ask_part(self, replies, first, at - first);
    reply_fill(replies, at, 1, end, ended);
    ask_part(self, replies, at + 1, first + count - at - 1);
}

static void ask_part(library *self, reply *replies, int first, int count)
{
    if (count == 0)
        return;
    if (candidate_is_spent(&self->common)) {
        reply_fill(replies, first, count, REPLY_UNASKED, 0);
        return;
    }
    reply_kind result = ask_child(self, first, count);
    if (result == REPLY_ANSWERED && self->from.path)
        read_replies(self, replies, first, count);
    else if (result != REPLY_ANSWERED)
        narrow_down(self, replies, first, count, result);
}

static void ask(candidate *common, block *asked)
{
    library *self = (library *)common;
    self->questions->shape = asked->shape;
    self->questions->in = common->answers_in[asked->shape];
    for (int i = 0; i < asked->count; i++)
        write_question(self->questions, &asked->cases[i], i);
    int ends = common->crashes + common->hangs;
    ask_part(self, asked->replies, 0, asked->count);
    bool whole = common->crashes + common->hangs == ends;
    asked->nanoseconds = whole ? self->answers->nanoseconds : 0;
    asked->with_normals = self->from.with_normals;
    for (int i = 0; self->from.path && i < asked->count; i++)
        asked->with_normals |= asked->replies[i].has_normal;
}

/* Opening and closing. */

static void close_library(candidate *common)
{
    library *self = (library *)common;
    child_stop(&self->process);
    if (self->questions)
        munmap(self->questions, sizeof *self->questions);
    if (self->answers)
        munmap(self->answers, sizeof *self->answers);
    free(self);
}

static void choose_functions(library *self, candidate_inputs inputs)
{
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        const bool *has = self->answers->has[shape];
        bool single =
            inputs == INPUTS_FLOAT || (inputs == INPUTS_AS_IT_TAKES && !has[PRECISION_DOUBLE]);
        self->common.answers_in[shape] = single ? PRECISION_FLOAT : PRECISION_DOUBLE;
        self->common.answers[shape] = has[self->common.answers_in[shape]];
    }
}

/* dlopen looks for a name without a slash elsewhere. */
static const char *with_slash(library *self, const char *path)
{
    if (!path || strchr(path, '/'))
        return path;
    snprintf(self->path, sizeof self->path, "./%s", path);
    return self->path;
}

static candidate *open_library(plugin_source from, const candidate_options *how, char *message)
{
    library *self = calloc(1, sizeof *self);
    snprintf(message, CANDIDATE_MESSAGE, "no memory");
    if (!self)
        return NULL;
    self->common = (candidate){
        .block_cases = PLUGIN_BLOCK, .is_quick = true, .ask = ask, .close = close_library};
    self->from = from;
    self->from.path = with_slash(self, from.path);
    self->time_limit = how->time_limit;
    self->questions = share(sizeof *self->questions);
    self->answers = share(sizeof *self->answers);
    signal(SIGPIPE, SIG_IGN);
    if (!self->questions || !self->answers || !is_loaded(self, message)) {
        close_library(&self->common);
        return NULL;
    }
    choose_functions(self, how->inputs);
    return &self->common;
}

candidate *candidate_of_library(const char *path, const candidate_options *how, char *message)
{
    return open_library((plugin_source){.path = path}, how, message);
}

candidate *candidate_of_tier_functions(sure_tier tier, bool with_normals,
                                       const candidate_options *how, char *message)
{
    return open_library((plugin_source){NULL, tier, with_normals}, how, message);
}

/* SPDX-License-Identifier: MIT */
/* A Python callable as a candidate. This module is the shared library that the judge loads, in
 * which it finds functions that ask the callable. It is called in a process of its own
 * (surehit/_judge.py), so that neither the judge's static data nor its end are the caller's, and
 * asks in a child of that, which a crash or a hang may cost. Both are copies of one thread that
 * holds Python's lock: they may use Python as it is. */
#include "module.h"

#include "../cli/options.h"
#include "../judge/candidates/child.h"

#include <surehit/candidate.h>

#include <locale.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define EXPORTED __attribute__((visibility("default")))

static PyObject *asked; /* the callable */

EXPORTED const int sure_candidate_version = SURE_CANDIDATE_VERSION;
/* sure_candidate_name, which is only known when it is called. */
EXPORTED char candidate_name[128] __asm__("sure_candidate_name");

static PyObject *view_of(const void *at, size_t size, int flags)
{
    return PyMemoryView_FromMemory((char *)at, (Py_ssize_t)size, flags);
}

/* ask(shape, is_float, rays, objects, statuses, hits): bytes, the last two to be written. What it
 * raises is its own to tell; here it is the end of the process. */
static void ask(sure_shape shape, int count, size_t real, const void *rays, const void *objects,
                int *statuses, void *hits, size_t hit)
{
    const size_t all = (size_t)count, numbers = (size_t)sure_shape_info_of(shape)->numbers;
    PyObject *said =
        PyObject_CallFunction(asked, "iiNNNN", (int)shape, (int)(real == sizeof(float)),
                              view_of(rays, all * 8 * real, PyBUF_READ),
                              view_of(objects, all * numbers * real, PyBUF_READ),
                              view_of(statuses, all * sizeof *statuses, PyBUF_WRITE),
                              view_of(hits, all * hit, PyBUF_WRITE));
    if (!said)
        _exit(EXIT_FAILURE);
    Py_DECREF(said);
}

#define MANY(shape, SHAPE, in, real)                                                               \
    EXPORTED void sure_candidate_##shape##_many##in(int count, const real *rays,                   \
                                                    const real *shape##s, int *statuses,           \
                                                    sure_candidate_hit##in *hits)                  \
    {                                                                                              \
        ask(SURE_SHAPE_##SHAPE, count, sizeof(real), rays, shape##s, statuses, hits,               \
            sizeof *hits);                                                                         \
    }
#define MANY_IN_BOTH(shape, SHAPE) MANY(shape, SHAPE, , double) MANY(shape, SHAPE, _float, float)
SURE_EACH_SHAPE(MANY_IN_BOTH)

/* The words of `surehit judge`, in UTF-8; they live as long as the process. */
static char **words_of(PyObject *list, int *count)
{
    *count = (int)PyTuple_Size(list);
    char **words = calloc((size_t)*count + 1, sizeof *words);
    for (int i = 0; words && i < *count; i++) {
        PyObject *bytes = PyUnicode_EncodeFSDefault(PyTuple_GetItem(list, i));
        if (!bytes || PyBytes_AsStringAndSize(bytes, &words[i], NULL) != 0)
            return NULL;
    }
    return words ? words : (char **)PyErr_NoMemory();
}

PyObject *module_judge(PyObject *self, PyObject *arguments)
{
    const char *name;
    PyObject *list;
    int count;
    (void)self;
    if (!PyArg_ParseTuple(arguments, "OsO!", &asked, &name, &PyTuple_Type, &list))
        return NULL;
    char **words = words_of(list, &count);
    if (!words)
        return NULL;
    strncpy(candidate_name, name, sizeof candidate_name - 1);
    setlocale(LC_NUMERIC, "C"); /* numbers are written with a point */
    child_begins();
    return PyLong_FromLong(cli_run(&command_judge, count, words));
}

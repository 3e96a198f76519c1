/* SPDX-License-Identifier: MIT */
/* Many rays in one call: arrays of any strides become the columns of many.h. */
#include "module.h"

#include <surehit/many.h>

#include <string.h>

enum { RAY = 8, INPUTS = RAY + SURE_SHAPE_NUMBERS, OUTPUTS = 6, AXES = 64 };

/* Number k of an array's last axis, and its strides along the others. */
typedef struct {
    char *first;
    const Py_ssize_t *strides;
} column;

typedef struct {
    sure_shape shape;
    sure_tier tier;
    int axes, inner; /* the one that a call of the library goes along */
    Py_ssize_t at[AXES];
    const Py_ssize_t *extents;
    int input_count;
    column inputs[INPUTS], status, part, leaves, t, t_error, normal[3];
} question;

/* Asking, without Python's lock. */

static char *place_of(const question *all, const column *of)
{
    char *place = of->first;
    for (int axis = 0; place && axis < all->axes; axis++)
        place += all->at[axis] * of->strides[axis];
    return place;
}

static ptrdiff_t stride_of(const question *all, const column *of)
{
    return of->first && all->inner >= 0 ? of->strides[all->inner] : 0;
}

static sure_numbers numbers_of(const question *all, const column *of)
{
    return (sure_numbers){place_of(all, of), stride_of(all, of)};
}

static sure_number_column number_column_of(const question *all, const column *of)
{
    return (sure_number_column){place_of(all, of), stride_of(all, of)};
}

static sure_byte_column byte_column_of(const question *all, const column *of)
{
    return (sure_byte_column){(uint8_t *)place_of(all, of), stride_of(all, of)};
}

static void ask_line(const question *all)
{
    sure_rays rays;
    sure_objects objects = {.shape = all->shape};
    sure_hits hits = {
        .status = byte_column_of(all, &all->status),
        .part = byte_column_of(all, &all->part),
        .leaves = byte_column_of(all, &all->leaves),
        .t = number_column_of(all, &all->t),
        .t_error = number_column_of(all, &all->t_error),
    };
    for (int k = 0; k < 3; k++)
        hits.normal[k] = number_column_of(all, &all->normal[k]);
    for (int k = 0; k < RAY; k++)
        ((sure_numbers *)(void *)&rays)[k] = numbers_of(all, &all->inputs[k]);
    for (int k = RAY; k < all->input_count; k++)
        objects.numbers[k - RAY] = numbers_of(all, &all->inputs[k]);
    const size_t count = all->inner < 0 ? 1 : (size_t)all->extents[all->inner];
    sure_objects_hits(count, &rays, &objects, all->tier, &hits);
}

static void ask_from(question *all, int axis)
{
    if (axis == all->inner)
        ask_from(all, axis + 1);
    else if (axis == all->axes)
        ask_line(all);
    else
        for (all->at[axis] = 0; all->at[axis] < all->extents[axis]; all->at[axis]++)
            ask_from(all, axis + 1);
    all->at[axis] = 0;
}

/* The arrays. */

typedef struct {
    Py_buffer views[INPUTS + OUTPUTS];
    int count;
} arrays;

static void release(arrays *held)
{
    while (held->count > 0)
        PyBuffer_Release(&held->views[--held->count]);
}

/* The array's view, whose items are of this format, at any alignment; NULL after an exception. */
static const Py_buffer *hold(arrays *held, PyObject *array, const char *format, int flags)
{
    Py_buffer *view = &held->views[held->count];
    if (PyObject_GetBuffer(array, view, PyBUF_STRIDES | PyBUF_FORMAT | flags) != 0)
        return NULL;
    held->count++;
    if (view->format && strcmp(view->format + strspn(view->format, "=@"), format) == 0)
        return view;
    PyErr_Format(PyExc_TypeError, "items of format '%s', not '%s'", view->format, format);
    return NULL;
}

/* An array has all axes of the question, and a last one of its own where it has several columns. */
static int has_axes(const question *all, const Py_buffer *view, int own)
{
    int same = view->ndim == all->axes + own;
    for (int axis = 0; same && axis < all->axes; axis++)
        same = view->shape[axis] == all->extents[axis];
    if (!same)
        PyErr_SetString(PyExc_ValueError, "arrays of different shapes");
    return same;
}

static int take_columns(const question *all, const Py_buffer *view, column *to, int most)
{
    const int last = all->axes;
    if (!has_axes(all, view, 1))
        return -1;
    if (view->shape[last] > most) {
        PyErr_SetString(PyExc_ValueError, "more numbers than a ray and its object have");
        return -1;
    }
    for (int k = 0; k < (int)view->shape[last]; k++)
        to[k] = (column){(char *)view->buf + k * view->strides[last], view->strides};
    return (int)view->shape[last];
}

/* The first array says which axes there are; the longest of them is gone along. */
static int take_extents(question *all, const Py_buffer *view)
{
    all->axes = view->ndim - 1;
    all->extents = view->shape;
    all->inner = -1;
    if (all->axes < 0 || all->axes >= AXES) {
        PyErr_SetString(PyExc_ValueError, "an array without axes, or with too many");
        return 0;
    }
    for (int axis = 0; axis < all->axes; axis++)
        if (all->inner < 0 || all->extents[axis] > all->extents[all->inner])
            all->inner = axis;
    return 1;
}

static int take_inputs(question *all, arrays *held, PyObject *inputs)
{
    const int wanted = RAY + sure_shape_info_of(all->shape)->numbers;
    const Py_ssize_t count = PyTuple_Size(inputs);
    for (Py_ssize_t i = 0; i < count && i < INPUTS; i++) {
        const Py_buffer *view = hold(held, PyTuple_GetItem(inputs, i), "d", 0);
        if (!view || (i == 0 && !take_extents(all, view)))
            return 0;
        const int columns =
            take_columns(all, view, all->inputs + all->input_count, wanted - all->input_count);
        if (columns < 0)
            return 0;
        all->input_count += columns;
    }
    if (all->input_count == wanted)
        return 1;
    PyErr_SetString(PyExc_ValueError, "fewer numbers than a ray and its object have");
    return 0;
}

/* status, part, leaves, t, t_error, normal; None is not wanted. */
static int take_outputs(question *all, arrays *held, PyObject *outputs)
{
    column *const to[OUTPUTS] = {&all->status, &all->part,    &all->leaves,
                                 &all->t,      &all->t_error, all->normal};
    static const char *const formats[OUTPUTS] = {"B", "B", "?", "d", "d", "d"};
    for (int i = 0; i < OUTPUTS; i++) {
        PyObject *array = PyTuple_GetItem(outputs, i);
        if (!array)
            return 0;
        if (i > 0 && array == Py_None)
            continue;
        const Py_buffer *view = hold(held, array, formats[i], PyBUF_WRITABLE);
        if (!view)
            return 0;
        if (i < OUTPUTS - 1) {
            if (!has_axes(all, view, 0))
                return 0;
            *to[i] = (column){view->buf, view->strides};
        } else if (take_columns(all, view, to[i], 3) < 0)
            return 0;
    }
    return 1;
}

PyObject *module_hits(PyObject *self, PyObject *arguments)
{
    int shape, tier, taken;
    PyObject *inputs, *outputs;
    arrays held = {.count = 0};
    (void)self;
    if (!PyArg_ParseTuple(arguments, "iiO!O!", &shape, &tier, &PyTuple_Type, &inputs, &PyTuple_Type,
                          &outputs))
        return NULL;
    if (!sure_shape_name((sure_shape)shape) || !sure_tier_name((sure_tier)tier))
        return PyErr_Format(PyExc_ValueError, "no such shape, or no such tier");
    question all = {.shape = (sure_shape)shape, .tier = (sure_tier)tier};
    taken = take_inputs(&all, &held, inputs) && take_outputs(&all, &held, outputs);
    if (taken) {
        PyThreadState *lock = PyEval_SaveThread();
        ask_from(&all, 0);
        PyEval_RestoreThread(lock);
    }
    release(&held);
    return taken ? Py_NewRef(Py_None) : NULL;
}

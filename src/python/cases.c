/* SPDX-License-Identifier: MIT */
/* The judge's cases, as numbers. */
#include "module.h"

#include "../cases/regimes.h"

static void make(sure_shape shape, regime which, uint64_t seed, uint64_t first, double *to,
                 uint64_t count)
{
    const int numbers = case_numbers(shape);
    for (uint64_t i = 0; i < count; i++, to += numbers) {
        const sure_case made = regime_case(shape, which, seed, first + i);
        case_to_numbers(&made, to);
    }
}

PyObject *module_cases(PyObject *self, PyObject *arguments)
{
    int shape, which;
    unsigned long long seed, first;
    PyObject *array;
    Py_buffer view;
    (void)self;
    if (!PyArg_ParseTuple(arguments, "iiKKO", &shape, &which, &seed, &first, &array))
        return NULL;
    if (!sure_shape_name((sure_shape)shape) || !regime_name((regime)which) ||
        !regime_applies((sure_shape)shape, (regime)which))
        return PyErr_Format(PyExc_ValueError, "no such shape, or no such regime of it");
    if (PyObject_GetBuffer(array, &view, PyBUF_C_CONTIGUOUS | PyBUF_WRITABLE) != 0)
        return NULL;
    const size_t one = (size_t)case_numbers((sure_shape)shape) * sizeof(double);
    PyThreadState *lock = PyEval_SaveThread();
    make((sure_shape)shape, (regime)which, seed, first, view.buf, (size_t)view.len / one);
    PyEval_RestoreThread(lock);
    PyBuffer_Release(&view);
    return Py_NewRef(Py_None);
}

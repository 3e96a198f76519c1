/* SPDX-License-Identifier: MIT */
#include "module.h"

#include "../cases/regimes.h"

#include <surehit/object.h>
#include <surehit/version.h>

/* A tuple of the names of 0, 1, ... */
static PyObject *names_of(const char *(*name)(int))
{
    PyObject *list = PyList_New(0);
    for (int i = 0; list && name(i); i++) {
        PyObject *text = PyUnicode_FromString(name(i));
        if (!text || PyList_Append(list, text) != 0)
            Py_CLEAR(list);
        Py_XDECREF(text);
    }
    PyObject *all = list ? PyList_AsTuple(list) : NULL;
    Py_XDECREF(list);
    return all;
}

#define NAMING(kind, of, name)                                                                     \
    static const char *name_of_##kind(int i)                                                       \
    {                                                                                              \
        return name((of)i);                                                                        \
    }
NAMING(shape, sure_shape, sure_shape_name)
NAMING(tier, sure_tier, sure_tier_name)
NAMING(part, sure_part, sure_part_name)
NAMING(status, sure_status, sure_status_name)
NAMING(regime, regime, regime_name)

/* fields(shape): (name, how many numbers) of each. */
static PyObject *fields(PyObject *self, PyObject *arguments)
{
    int shape;
    (void)self;
    if (!PyArg_ParseTuple(arguments, "i", &shape))
        return NULL;
    if (!sure_shape_name((sure_shape)shape))
        return PyErr_Format(PyExc_ValueError, "no such shape");
    const sure_shape_info *info = sure_shape_info_of((sure_shape)shape);
    PyObject *all = PyTuple_New(info->field_count);
    for (int i = 0; all && i < info->field_count; i++) {
        const sure_shape_field *field = &info->fields[i];
        PyObject *one = Py_BuildValue("(si)", sure_field_name(field->name),
                                      field->kind == SURE_KIND_RADIUS ? 1 : 3);
        if (!one || PyTuple_SetItem(all, i, one) != 0)
            Py_CLEAR(all);
    }
    return all;
}

/* check(shape, numbers): the first invalid field of ray and object, or "none". */
static PyObject *check(PyObject *self, PyObject *arguments)
{
    int shape;
    PyObject *numbers;
    double values[CASE_NUMBERS_MAX];
    (void)self;
    if (!PyArg_ParseTuple(arguments, "iO!", &shape, &PyTuple_Type, &numbers))
        return NULL;
    if (!sure_shape_name((sure_shape)shape) ||
        PyTuple_Size(numbers) != case_numbers((sure_shape)shape))
        return PyErr_Format(PyExc_ValueError, "no such shape, or not its numbers");
    for (int i = 0; i < case_numbers((sure_shape)shape); i++)
        values[i] = PyFloat_AsDouble(PyTuple_GetItem(numbers, i));
    if (PyErr_Occurred())
        return NULL;
    const sure_case all = case_from_numbers((sure_shape)shape, values);
    return PyUnicode_FromString(sure_field_name(sure_object_check(&all.ray, &all.object)));
}

/* applies(shape, regime): does the regime mean anything for the shape? */
static PyObject *applies(PyObject *self, PyObject *arguments)
{
    int shape, which;
    (void)self;
    if (!PyArg_ParseTuple(arguments, "ii", &shape, &which))
        return NULL;
    if (!sure_shape_name((sure_shape)shape) || !regime_name((regime)which))
        return PyErr_Format(PyExc_ValueError, "no such shape, or no such regime");
    return PyBool_FromLong(regime_applies((sure_shape)shape, (regime)which));
}

static PyMethodDef methods[] = {
    {"hits", module_hits, METH_VARARGS, NULL},
    {"cases", module_cases, METH_VARARGS, NULL},
    {"judge", module_judge, METH_VARARGS, NULL},
    {"fields", fields, METH_VARARGS, NULL},
    {"check", check, METH_VARARGS, NULL},
    {"applies", applies, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static bool add(PyObject *module, const char *name, PyObject *value)
{
    const bool added = value && PyModule_AddObjectRef(module, name, value) == 0;
    Py_XDECREF(value);
    return added;
}

static bool fill(PyObject *module)
{
    return add(module, "SHAPES", names_of(name_of_shape)) &&
           add(module, "TIERS", names_of(name_of_tier)) &&
           add(module, "PARTS", names_of(name_of_part)) &&
           add(module, "STATUSES", names_of(name_of_status)) &&
           add(module, "REGIMES", names_of(name_of_regime)) &&
           add(module, "VERSION", PyUnicode_FromString(SUREHIT_VERSION_TEXT));
}

static PyModuleDef definition = {
    .m_base = PyModuleDef_HEAD_INIT, .m_name = "_surehit", .m_size = -1, .m_methods = methods};

PyMODINIT_FUNC PyInit__surehit(void);
PyMODINIT_FUNC PyInit__surehit(void)
{
    PyObject *module = PyModule_Create(&definition);
    if (module && !fill(module))
        Py_CLEAR(module);
    return module;
}

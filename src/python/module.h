/* SPDX-License-Identifier: MIT */
/* The Python module surehit._surehit: what needs C, for surehit/__init__.py, which looks at what
 * users give. In the limited API of Python 3.11, so that one file serves all later ones. */
#pragma once

#include <Python.h>

/* hits(shape, tier, inputs, outputs): as __init__.pyi of the module says. */
PyObject *module_hits(PyObject *self, PyObject *arguments);

/* cases(shape, regime, seed, first, numbers) */
PyObject *module_cases(PyObject *self, PyObject *arguments);

/* judge(ask, name, words) */
PyObject *module_judge(PyObject *self, PyObject *arguments);

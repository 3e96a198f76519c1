/* SPDX-License-Identifier: MIT */
/* The middle one of some numbers. */
#pragma once

#include <stdlib.h>

static inline int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static inline void sort_doubles(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, by_size);
}

/* Of an odd number of values, which are sorted then. */
static inline double median_of(double *values, int count)
{
    sort_doubles(values, count);
    return values[count / 2];
}

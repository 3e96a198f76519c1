/* OpenMP where there is any; one thread, and nothing to be warned of, where there is none. */
#pragma once

#ifdef _OPENMP
#include <omp.h>
#define OPENMP(directive) _Pragma(#directive)
#else
#define OPENMP(directive)
#endif

/* How many threads are meant; 0: one a core. */
static inline int openmp_threads(int asked)
{
#ifdef _OPENMP
    return asked > 0 ? asked : omp_get_num_procs();
#else
    (void)asked;
    return 1;
#endif
}

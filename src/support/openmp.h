/* OpenMP where there is any; one thread, and nothing to be warned of, where there is none. */
#pragma once

#ifdef _OPENMP
#include <omp.h>
#define OPENMP(directive) _Pragma(#directive)
#else
#define OPENMP(directive)
#endif

/* How many threads are meant; 0: one a core. */
static inline int openmp_threads(int wanted)
{
#ifdef _OPENMP
    return wanted > 0 ? wanted : omp_get_num_procs();
#else
    (void)wanted;
    return 1;
#endif
}

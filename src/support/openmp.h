/* SPDX-License-Identifier: MIT */
/* OpenMP where there is any; one thread, and nothing to be warned of, where there is none. */
#pragma once

#ifdef _OPENMP
#include <omp.h>
#include <pthread.h>
#define OPENMP(directive) _Pragma(#directive)

#define OPENMP_MOST 1024

/* Waits until it is let go, so that all those that are tried are there at once. */
static inline void *openmp_wait(void *gate)
{
    pthread_mutex_lock(gate);
    pthread_mutex_unlock(gate);
    return NULL;
}

/* So many threads, or as many as there is memory and leave for: OpenMP would end the program. */
static inline int openmp_had(int wanted)
{
    static pthread_mutex_t gate = PTHREAD_MUTEX_INITIALIZER;
    pthread_t tried[OPENMP_MOST];
    int count = 0;
    pthread_mutex_lock(&gate);
    while (count < wanted - 1 && count < OPENMP_MOST &&
           pthread_create(&tried[count], NULL, openmp_wait, &gate) == 0)
        count++;
    pthread_mutex_unlock(&gate);
    for (int i = 0; i < count; i++)
        pthread_join(tried[i], NULL);
    return count + 1;
}
#else
#define OPENMP(directive)
#endif

/* How many threads there are to be; 0: one a core. Fewer where they can't be had. */
static inline int openmp_threads(int wanted)
{
#ifdef _OPENMP
    static int asked, had; /* the last time, which OpenMP has kept */
    if (wanted == 0)
        wanted = omp_get_num_procs();
    if (wanted != asked) {
        asked = wanted;
        had = openmp_had(wanted);
    }
    return had;
#else
    (void)wanted;
    return 1;
#endif
}

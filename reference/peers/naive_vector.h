/* SPDX-License-Identifier: MIT */
/* The two vector operations of the naive peers. Frozen with them. */
#ifndef PEERS_NAIVE_VECTOR_H
#define PEERS_NAIVE_VECTOR_H

#include <surehit/vector.h>

static inline double dot(sure_vec3 a, sure_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline sure_vec3 sub(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

#endif

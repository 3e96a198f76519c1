/* SPDX-License-Identifier: MIT */
/* What the adapters of libraries have in common. Each adapter is one shared library that hands a
 * case to the library as its documentation wants it, and says in its entry what that is
 * (docs/judge.md, "Entry conditions"): what the judge can make so no adapter computes. */
#pragma once

#include "../precision.h"

#include <cmath>
#include <memory>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;
const char sure_candidate_name[] = PEER_LIBRARY;
const char sure_candidate_release[] = PEER_RELEASE; /* the package's */

/* A hit at t, a miss where t is no number or outside of the range. */
static inline int found_at(const real *ray, real t, peer_hit *hit)
{
    if (!(t >= ray[6] && t <= ray[7] && std::isfinite(t)))
        return SURE_CANDIDATE_MISS;
    hit->t = t;
    return SURE_CANDIDATE_HIT;
}

/* The library's own object is built once for all rays. Object is made of the words behind it, where
 * n are the shape's numbers, and has `int meet(const real *ray, peer_hit *hit) const`. By what the
 * library throws it refuses the numbers. */
#define ANSWER_BY(shape, Object, ...)                                                              \
    void *PEER(shape##_new)([[maybe_unused]] const real *n)                                        \
    {                                                                                              \
        try {                                                                                      \
            return new Object{__VA_ARGS__};                                                        \
        } catch (...) {                                                                            \
            return nullptr;                                                                        \
        }                                                                                          \
    }                                                                                              \
    void sure_candidate_##shape##_free(void *prepared)                                             \
    {                                                                                              \
        delete static_cast<Object *>(prepared);                                                    \
    }                                                                                              \
    int PEER(shape##_prepared)(const real *ray, void *prepared, peer_hit *hit)                     \
    {                                                                                              \
        return static_cast<const Object *>(prepared)->meet(ray, hit);                              \
    }

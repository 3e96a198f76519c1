/* SPDX-License-Identifier: MIT */
/* What a peer computes in: double, or float with -DPEER_FLOAT. */
#ifndef PEERS_PRECISION_H
#define PEERS_PRECISION_H

#include <math.h>
#include <surehit/candidate.h>

#ifdef PEER_FLOAT
typedef float real;
typedef sure_candidate_hit_float peer_hit;
#define PEER(shape) sure_candidate_##shape##_float
#define square_root sqrtf
#define size_of fabsf
#else
typedef double real;
typedef sure_candidate_hit peer_hit;
#define PEER(shape) sure_candidate_##shape
#define square_root sqrt
#define size_of fabs
#endif

#endif

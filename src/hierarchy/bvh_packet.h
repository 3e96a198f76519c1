/* SPDX-License-Identifier: MIT */
/* Which of eight rays meet a box? bvh_walk.h's operations, of one child and eight rays. */
#pragma once

#include "bvh_walk.h"

#include <string.h>
#ifdef __AVX2__
#include <immintrin.h>
#endif

enum { BVH_PACKET = 8 };

#define BVH_ALIGNED __attribute__((aligned(64)))

/* The probes of rays that see the same faces of boxes first: near and far are all's. */
typedef struct {
    double o[3][BVH_PACKET], to_near[3][BVH_PACKET], to_far[3][BVH_PACKET];
    double t_min[BVH_PACKET], slack[BVH_PACKET];
    size_t near[3], far[3];
} BVH_ALIGNED bvh_packet;

static inline void bvh_packet_set(bvh_packet *rays, size_t i, const bvh_probe *probe)
{
    for (int k = 0; k < 3; k++) {
        rays->o[k][i] = probe->o[k];
        rays->to_near[k][i] = probe->to_near[k];
        rays->to_far[k][i] = probe->to_far[k];
    }
    rays->t_min[i] = probe->t_min;
    rays->slack[i] = probe->slack;
}

#if defined(__AVX512F__)
static inline unsigned bvh_packet_meets(const sure_bvh_node *node, int k, const bvh_packet *rays,
                                        const double t_max[BVH_PACKET], double enter[BVH_PACKET])
{
    __m512d from = _mm512_load_pd(rays->t_min), to = _mm512_load_pd(t_max);
    BVH_LANES
    for (int i = 0; i < 3; i++) {
        __m512d o = _mm512_load_pd(rays->o[i]);
        __m512d near = _mm512_set1_pd(bvh_row(node, rays->near[i])[k]);
        __m512d far = _mm512_set1_pd(bvh_row(node, rays->far[i])[k]);
        from = _mm512_max_pd((near - o) * _mm512_load_pd(rays->to_near[i]), from);
        to = _mm512_min_pd((far - o) * _mm512_load_pd(rays->to_far[i]), to);
    }
    _mm512_store_pd(enter, from);
    return _mm512_cmp_pd_mask(from, to + _mm512_load_pd(rays->slack), _CMP_LE_OQ);
}

/* Which rays enter at most so far away? */
static inline unsigned bvh_packet_before(const bvh_packet *rays, const double enter[BVH_PACKET],
                                         const double t_max[BVH_PACKET])
{
    return _mm512_cmp_pd_mask(_mm512_load_pd(enter),
                              _mm512_load_pd(t_max) + _mm512_load_pd(rays->slack), _CMP_NGT_UQ);
}
#elif defined(__AVX2__)
static inline unsigned bvh_packet_meets(const sure_bvh_node *node, int k, const bvh_packet *rays,
                                        const double t_max[BVH_PACKET], double enter[BVH_PACKET])
{
    unsigned meets = 0;
    for (int h = 0; h < BVH_PACKET; h += 4) {
        __m256d from = _mm256_load_pd(rays->t_min + h), to = _mm256_load_pd(t_max + h);
        for (int i = 0; i < 3; i++) {
            __m256d o = _mm256_load_pd(rays->o[i] + h);
            __m256d near = _mm256_set1_pd(bvh_row(node, rays->near[i])[k]);
            __m256d far = _mm256_set1_pd(bvh_row(node, rays->far[i])[k]);
            from = _mm256_max_pd((near - o) * _mm256_load_pd(rays->to_near[i] + h), from);
            to = _mm256_min_pd((far - o) * _mm256_load_pd(rays->to_far[i] + h), to);
        }
        _mm256_store_pd(enter + h, from);
        meets |= (unsigned)_mm256_movemask_pd(_mm256_cmp_pd(
                     from, to + _mm256_load_pd(rays->slack + h), _CMP_LE_OQ))
                 << h;
    }
    return meets;
}

static inline unsigned bvh_packet_before(const bvh_packet *rays, const double enter[BVH_PACKET],
                                         const double t_max[BVH_PACKET])
{
    unsigned before = 0;
    for (int h = 0; h < BVH_PACKET; h += 4)
        before |= (unsigned)_mm256_movemask_pd(_mm256_cmp_pd(
                      _mm256_load_pd(enter + h),
                      _mm256_load_pd(t_max + h) + _mm256_load_pd(rays->slack + h), _CMP_NGT_UQ))
                  << h;
    return before;
}
#else
static inline unsigned bvh_packet_meets(const sure_bvh_node *node, int k, const bvh_packet *rays,
                                        const double t_max[BVH_PACKET], double enter[BVH_PACKET])
{
    unsigned meets = 0;
    for (int h = 0; h < BVH_PACKET; h++) {
        double from = rays->t_min[h], to = t_max[h];
        for (int i = 0; i < 3; i++) {
            const double near = bvh_row(node, rays->near[i])[k], far = bvh_row(node, rays->far[i])[k];
            from = bvh_later((near - rays->o[i][h]) * rays->to_near[i][h], from);
            to = bvh_earlier((far - rays->o[i][h]) * rays->to_far[i][h], to);
        }
        enter[h] = from;
        meets |= (unsigned)(from <= to + rays->slack[h]) << h;
    }
    return meets;
}

static inline unsigned bvh_packet_before(const bvh_packet *rays, const double enter[BVH_PACKET],
                                         const double t_max[BVH_PACKET])
{
    unsigned before = 0;
    for (int h = 0; h < BVH_PACKET; h++)
        before |= (unsigned)!(enter[h] > t_max[h] + rays->slack[h]) << h;
    return before;
}
#endif

/* SPDX-License-Identifier: MIT */
/* Rays that are asked about boxes side by side, by the operations of bvh_walk.h. Behind
 * shapes/lanes/lanes.h; the columns are of BVH_PACKET doubles. */
#pragma once

#include "bvh_axis.h"

enum { BVH_COLUMN = BVH_PACKET * LANES_STRIDE, BVH_STEP = LANES * LANES_STRIDE };

/* All numbers of the rays' probes but for the rows, which are those of the first ray. */
typedef struct {
    double o[3][BVH_PACKET / LANES], to_near[3][BVH_PACKET / LANES], to_far[3][BVH_PACKET / LANES];
    double t_min[BVH_PACKET / LANES], slack[BVH_PACKET / LANES];
    size_t near[3], far[3];
} bvh_packet;

#define BVH_EACH_LANES _Pragma("GCC unroll 4") for (int h = 0; h < BVH_PACKET / LANES; h++)
#define BVH_EACH_AXIS _Pragma("GCC unroll 3") for (int i = 0; i < 3; i++)

static inline double bvh_column(const void *column, int h)
{
    return lanes_at((const char *)column + h * BVH_STEP);
}

/* column: origin, direction, t_min. A bit a ray: does it see the faces first that the first ray
 * does? Of those that don't, nothing is known. */
static inline unsigned bvh_packet_of(bvh_packet *rays, const void *columns)
{
    const char *column = columns;
    unsigned apart = 0;
    BVH_EACH_LANES
    {
        rays->t_min[h] = bvh_column(column + 6 * BVH_COLUMN, h);
        rays->slack[h] = (double){0} + WALK_FLUSHED;
    }
    BVH_EACH_AXIS
    {
        unsigned down = 0;
        BVH_EACH_LANES
        {
            const bvh_axis axis = bvh_axis_of(bvh_column(column + i * BVH_COLUMN, h),
                                              bvh_column(column + (3 + i) * BVH_COLUMN, h));
            rays->o[i][h] = axis.o;
            rays->to_near[i][h] = axis.to_near;
            rays->to_far[i][h] = axis.to_far;
            rays->slack[h] = bvh_later(axis.slack, rays->slack[h]);
            down |= lanes_bit_each(axis.down) << h * LANES;
        }
        const unsigned first = down & 1;
        apart |= down ^ (0U - first);
        rays->near[i] = bvh_row_at(2 * i + (int)first);
        rays->far[i] = bvh_row_at(2 * i + !first);
    }
    return ~apart & ((1U << BVH_PACKET) - 1);
}

/* A bit a ray: where does it meet the box of child k, up to t_max? */
static inline unsigned bvh_packet_meets(const sure_bvh_node *node, int k, const bvh_packet *rays,
                                        const void *t_max, void *enter)
{
    unsigned meets = 0;
    BVH_EACH_LANES
    {
        double from = rays->t_min[h], to = bvh_column(t_max, h);
        BVH_EACH_AXIS
        {
            from = bvh_later(bvh_at(lanes_all_at(bvh_row(node, rays->near[i]) + k), rays->o[i][h],
                                    rays->to_near[i][h]),
                             from);
            to = bvh_earlier(bvh_at(lanes_all_at(bvh_row(node, rays->far[i]) + k), rays->o[i][h],
                                    rays->to_far[i][h]),
                             to);
        }
        lanes_to((char *)enter + h * BVH_STEP, from);
        meets |= lanes_bit_each(from <= to + rays->slack[h]) << h * LANES;
    }
    return meets;
}

/* A bit a ray: can what is entered there lie before t_max? */
static inline unsigned bvh_packet_before(const bvh_packet *rays, const void *enter,
                                         const void *t_max)
{
    unsigned before = 0;
    BVH_EACH_LANES
    before |= lanes_bit_each(bvh_column(enter, h) <= bvh_column(t_max, h) + rays->slack[h])
              << h * LANES;
    return before;
}

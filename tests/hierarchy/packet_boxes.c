/* SPDX-License-Identifier: MIT */
#include "packet_boxes.h"

#ifdef BOXES_TOGETHER
#include "../../src/hierarchy/bvh_row.h"

#include "../../src/shapes/lanes/lanes.h"

enum { BVH_PACKET = BOXES_PACKET };
#include "../../src/hierarchy/bvh_packet.h"

unsigned packet_boxes_met(const sure_bvh_node *node, int k, boxes_column *rays,
                          const boxes_column t_max, const boxes_column endless)
{
    bvh_packet probe;
    boxes_column enter;
    const unsigned together = bvh_packet_of(&probe, rays);
    const unsigned met = bvh_packet_meets(node, k, &probe, t_max, enter);
    const unsigned at_all = bvh_packet_meets(node, k, &probe, endless, enter);
    return together & met & at_all & bvh_packet_before(&probe, enter, t_max);
}
#endif

/* SPDX-License-Identifier: MIT */
/* What a packet is told of boxes, by the headers of src, two rays side by side: as many as every
 * processor has that knows packets. */
#pragma once

#include <surehit/bvh.h>

#if defined SURE_LANES_X86 || defined SURE_LANES_2
#define BOXES_TOGETHER /* where there are packets */
#endif

enum { BOXES_PACKET = 8 };

typedef double boxes_column[BOXES_PACKET];

/* Rays by column: origin, direction, t_min; the range, and one without end. A bit a ray: it goes
 * with the first one and meets the box of child k, where its range is known at once, and where it
 * is found out later. */
unsigned packet_boxes_met(const sure_bvh_node *node, int k, boxes_column *rays,
                          const boxes_column t_max, const boxes_column endless);

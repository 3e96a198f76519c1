/* SPDX-License-Identifier: MIT */
#include "../stages/hits/block.h"

#include "packet.h"

const packet_walks *packet_walks_here(void)
{
    switch (block_lanes()) {
#ifdef SURE_LANES_X86
    case 8: return &packet_walks_8;
    case 4: return &packet_walks_4;
#endif
#ifdef SURE_LANES_2
    case 2: return &packet_walks_2;
#endif
    default: return NULL;
    }
}

/* SPDX-License-Identifier: MIT */
/* The cylinder_height stem's formula, for the stems between two end planes. */
#pragma once

#include "cylinder_wall.h"

#include <assert.h>

/* The points with N.(P - base) >= 0 and N.(P - top) <= 0, where N.(P - base) = t N.d - N.rc:
 *
 *     t_base = N.rc / N.d,  t_top = (N.rc + N.N) / N.d
 *
 * N.d = 0: the line keeps its height -N.rc; on 0 or N.N it lies in a cap's plane.
 */
/* Base, then top. Entry: N.d is not 0. */
static inline void cylinder_height_ends(const cylinder_line *line, real ends[2])
{
    assert(line->n_d != 0);
    ends[0] = line->n_rc / line->n_d;
    ends[1] = (line->n_rc + line->n_n) / line->n_d;
}

static inline span cylinder_height_span(const cylinder_line *line)
{
    if (line->n_d == 0) {
        real height = -line->n_rc;
        if (!(height >= 0 && height <= line->n_n))
            return span_empty();
        bool in_base = height == 0, in_top = height == line->n_n;
        sure_part part = in_base ? SURE_PART_BASE : in_top ? SURE_PART_TOP : SURE_PART_WALL;
        return span_line(part, in_base || in_top);
    }
    real ends[2];
    cylinder_height_ends(line, ends);
    span up = {ends[0], ends[1], SURE_PART_BASE, SURE_PART_TOP, false, false, SURE_PART_WALL};
    span down = {ends[1], ends[0], SURE_PART_TOP, SURE_PART_BASE, false, false, SURE_PART_WALL};
    return line->n_d > 0 ? up : down;
}

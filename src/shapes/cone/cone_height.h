/* SPDX-License-Identifier: MIT */
/* The cone_height stem's formula, for the stems that keep one nappe of a double cone. */
#pragma once

#include "cone_wall.h"

#include <assert.h>

/* What the body of the kept nappe leaves of the line, up to what the slab between apex and base
 * cuts off anyway. With q(t) = a t^2 + b t + c <= 0 in the double cone and N.(rq - t d) >= 0 on the
 * kept nappe:
 *
 *     a > 0  the line is inside one nappe between the roots
 *     a < 0  it is inside both, beyond the roots: kept is the end to which it descends, N.d < 0 for
 *            t -> +infinity (D/4 >= 0 here; rounding below zero is zero)
 *     a = 0  parallel to a generator: one root; or, b = 0 too, the generator itself (c = 0)
 */
static inline span cone_height_kept(real a, const real roots[2], real n_d)
{
    const real infinity = (real)INFINITY;
    if (a > 0)
        return span_of(roots[0], roots[1], SURE_PART_WALL);
    return n_d < 0 ? span_of(roots[1], infinity, SURE_PART_WALL)
                   : span_of(-infinity, roots[0], SURE_PART_WALL);
}

static inline span cone_height_nappe(const cone_line *line)
{
    const real infinity = (real)INFINITY;
    quadratic q = cone_wall_quadratic(line);
    if (q.a == 0 && q.half_b == 0)
        return q.c <= 0 ? span_line(SURE_PART_WALL, true) : span_empty();
    if (q.a == 0) {
        real root = -(q.c / q.half_b) / 2;
        return q.half_b > 0 ? span_of(-infinity, root, SURE_PART_WALL)
                            : span_of(root, infinity, SURE_PART_WALL);
    }
    real roots[2];
    if (!quadratic_roots(q.a, q.half_b, q.c, roots)) {
        if (!(q.a < 0))
            return span_empty();
        roots[0] = roots[1] = -q.half_b / q.a;
    }
    return cone_height_kept(q.a, roots, line->n_d);
}

/* 0 <= N.(rq - t d) <= N.N, apex and base planes included:
 *
 *     t_apex = N.rq / N.d,  t_base = (N.rq - N.N) / N.d
 *
 * The apex is a point of the wall. N.d = 0: the line keeps its depth N.rq.
 */
/* Base, then apex. Entry: N.d is not 0. */
static inline void cone_height_ends(const cone_line *line, real ends[2])
{
    assert(line->n_d != 0);
    ends[0] = (line->n_rq - line->n_n) / line->n_d;
    ends[1] = line->n_rq / line->n_d;
}

static inline span cone_height_span(const cone_line *line)
{
    if (line->n_d == 0) {
        if (!(line->n_rq >= 0 && line->n_rq <= line->n_n))
            return span_empty();
        bool in_base = line->n_rq == line->n_n;
        return span_line(in_base ? SURE_PART_BASE : SURE_PART_WALL, in_base);
    }
    real ends[2];
    cone_height_ends(line, ends);
    span up = {ends[0], ends[1], SURE_PART_BASE, SURE_PART_WALL, false, false, SURE_PART_WALL};
    span down = {ends[1], ends[0], SURE_PART_WALL, SURE_PART_BASE, false, false, SURE_PART_WALL};
    return line->n_d > 0 ? up : down;
}

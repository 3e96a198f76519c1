/* SPDX-License-Identifier: MIT */
/* An object's own frame, as renderers have it that keep their shapes about the z axis: z from the
 * base to the other end, x and y any. */
#ifndef PEERS_AXIS_FRAME_H
#define PEERS_AXIS_FRAME_H

#include "peer.h"

typedef struct {
    vec3 x, y, z; /* of length 1 */
    real h;       /* |other end - base| */
} axis_frame;

static inline axis_frame frame_about(vec3 n)
{
    real h = square_root(dot(n, n));
    vec3 z = scaled(1 / h, n), x;
    if (size_of(z.x) > size_of(z.y))
        x = scaled(1 / square_root(z.x * z.x + z.z * z.z), (vec3){-z.z, 0, z.x});
    else
        x = scaled(1 / square_root(z.y * z.y + z.z * z.z), (vec3){0, z.z, -z.y});
    return (axis_frame){x, cross(z, x), z, h};
}

static inline vec3 in_frame(const axis_frame *frame, vec3 v)
{
    return (vec3){dot(frame->x, v), dot(frame->y, v), dot(frame->z, v)};
}

#endif

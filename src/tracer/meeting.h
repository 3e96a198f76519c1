/* SPDX-License-Identifier: MIT */
/* Where a ray meets a surface: its side, where further rays leave it, how it parts the light. */
#pragma once

#include "statistics.h"

#include <surehit/spawn.h>

#include <stdbool.h>

/* A hit as it is seen from where the ray comes from. */
typedef struct {
    const sure_ray *ray;
    const sure_nearest *nearest;
    const sure_object *object;
    const sure_material *material;
    sure_vec3 point;  /* o + t d, rounded */
    sure_vec3 normal; /* unit, on the side that is seen */
    sure_side side;   /* that side */
    sure_part part;   /* the hit's; of a flat box's two faces the one that is seen */
    bool flat_box;    /* a sheet, though of a solid's shape */
} meeting;

/* Where the range of a ray begins that leaves no surface, an eye's or a light's: what it touches is
 * not in front of it. The tier's least number above 0. */
static inline double in_front(sure_tier tier)
{
    return tier == SURE_TIER_FLOAT32 ? 0x1p-149 : 0x1p-1074;
}

/* Of a ray that leaves a surface point, or (NULL) none. */
void meeting_of(const tracing *t, const sure_ray *ray, const sure_surface_point *leaving,
                const sure_nearest *nearest, meeting *at);

/* Is the light on the side that is seen, and its direction known? By the plane of a flat part in
 * the tiers that are sure, where a highlight, which does not fade towards that plane, would show a
 * mistake; else by the intensity, which is that of the rounded point. */
bool meeting_faces(const tracing *t, const meeting *at, sure_vec3 light, double intensity);

/* Where further rays start, on the side that is seen or the other one; false where there is no
 * place. */
bool meeting_leave(const tracing *t, const meeting *at, sure_side side, sure_surface_point *from);

/* The side that is not seen. */
sure_side meeting_beyond(const meeting *at);

/* Is it refracting? */
static inline bool meeting_is_clear(const meeting *at)
{
    return at->material->refract > 0;
}

/* How a clear surface parts what arrives. */
typedef struct {
    double share;        /* that is reflected: Fresnel's, and the mirror's of the rest */
    sure_vec3 direction; /* in which what is left goes on, where anything is */
} parting;

parting meeting_part(const meeting *at);

/* Where the reflected share goes. */
sure_vec3 meeting_reflect(const meeting *at);

/* SPDX-License-Identifier: MIT */
/* A cell of a cube's face is seen from its middle as
 *
 *     solid angle = area / (1 + u^2 + v^2)^(3/2)
 *
 * where the face is at distance 1, about the direction (1, u, v). A photon has the share of its
 * light's power that goes into its part of the cell. */
#include <surehit/mixed.h>

#include "../geometry/coordinate.h"
#include "../numbers/valid.h"
#include "photon.h"

#include <assert.h>

static bool is_black(sure_vec3 color)
{
    return !(color.x > 0 || color.y > 0 || color.z > 0);
}

int sure_mixed_is_shiny(const sure_material *material)
{
    return material->mirror > 0 || material->refract > 0;
}

int sure_mixed_is_matte(const sure_material *material)
{
    return !(material->refract > 0) && material->mirror < 1 && !is_black(material->color);
}

/* Which columns an object is in. */

/* An object seen from a light, along an axis and across it: a box or, rounder, a ball. The octant's
 * signs are taken away. */
typedef struct {
    double low[2], high[2]; /* along, across */
    bool is_ball;
    double centre[2], radius;
} outline;

/* A ball is what has a centre and a radius, and nothing else. */
static outline outline_of(const sure_object *object, const sure_bounds *box, sure_vec3 light,
                          const int axes[2], int octant)
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    const double *numbers = (const double *)&object->as, *centre = numbers + info->fields[0].at;
    outline o = {.is_ball = info->field_count == 2 && info->fields[1].kind == SURE_KIND_RADIUS};
    o.radius = o.is_ball ? numbers[info->fields[1].at] : 0;
    for (int i = 0; i < 2; i++) {
        const int axis = axes[i];
        const double from = coordinate(light, axis), sign = (octant >> axis) & 1 ? -1 : 1;
        double low = sign * (box->low[axis] - from), high = sign * (box->high[axis] - from);
        o.low[i] = sign < 0 ? high : low;
        o.high[i] = sign < 0 ? low : high;
        o.centre[i] = sign * (centre[axis] - from);
    }
    return o;
}

/* Is the sum below 0, certainly? It has at most six roundings of terms that are no greater than
 * `size` in all, and each is off by at most 2^-1022 where it underflows, or is flushed. */
static bool is_negative(double sum, double size)
{
    return sum + 0x1p-48 * size < -0x1p-1018;
}

/* Does the object lie beyond the plane across = slope along, on the side of greater (sign 1) or
 * lesser (-1) slopes, with any of its points? What does not lies where sign (across - slope along)
 * is negative for all of it: at its greatest. */
static bool reaches(const outline *o, double slope, double sign)
{
    double across = sign > 0 ? o->high[1] : -o->low[1];
    double along = sign > 0 ? slope * o->low[0] : -(slope * o->high[0]);
    if (is_negative(across - along, fabs(across) + fabs(along)))
        return false;
    if (!o->is_ball)
        return true;
    across = sign * o->centre[1];
    along = sign * (slope * o->centre[0]);
    double reach = o->radius * sqrt(1 + slope * slope);
    return !is_negative(across - along + reach, fabs(across) + fabs(along) + reach);
}

/* What reaches a slope from above reaches all lesser ones from above. */
sure_mixed_strip sure_mixed_strip_of(const sure_object *object, sure_vec3 light_position, int axis,
                                     int octant, int along, int cells)
{
    assert(sure_object_check(&(sure_ray){{0, 0, 0}, {1, 0, 0}, 0, 0}, object) == SURE_FIELD_NONE);
    assert(all_finite(light_position));
    assert(axis >= 0 && axis < 3 && octant >= 0 && octant < 8 && (along == 1 || along == 2));
    assert(cells > 0 && (cells & (cells - 1)) == 0);
    const sure_mixed_strip all = {0, cells - 1}, none = {0, -1};
    const int axes[2] = {axis, (axis + along) % 3};
    sure_bounds box;
    if (!sure_bvh_box(object, &box))
        return all;
    outline o = outline_of(object, &box, light_position, axes, octant);
    if (o.high[0] < 0 || o.high[1] < 0)
        return none;
    sure_mixed_strip strip = all;
    while (strip.first <= strip.last && !reaches(&o, (double)(strip.first + 1) / cells, -1))
        strip.first++;
    while (strip.last >= strip.first && !reaches(&o, (double)strip.last / cells, 1))
        strip.last--;
    return strip;
}

/* Cells that are mirror images of one another have the same stream. */
static uint64_t number_of(const sure_mixed_cell *cell, uint32_t number)
{
    uint64_t cells = (uint64_t)cell->cells;
    uint64_t place = ((uint64_t)cell->light * 3 + (uint64_t)cell->axis) * cells * cells +
                     (uint64_t)cell->row * cells + (uint64_t)cell->column;
    return place << 32 | number;
}

/* Where in the cell, as a part of the face's half. */
static double place_in(int index, int cells, uint32_t part, uint32_t strata, random_stream *random)
{
    return (index + (part + random_fraction(random)) / strata) / cells;
}

static sure_vec3 turned(const double direction[3], int octant)
{
    return (sure_vec3){octant & 1 ? -direction[0] : direction[0],
                       octant & 2 ? -direction[1] : direction[1],
                       octant & 4 ? -direction[2] : direction[2]};
}

static void leave_light(photon *p, const sure_light *light, const sure_mixed_cell *cell,
                        uint32_t strata, uint32_t number)
{
    double u = place_in(cell->column, cell->cells, number % strata, strata, &p->random);
    double v = place_in(cell->row, cell->cells, number / strata, strata, &p->random);
    double direction[3];
    direction[cell->axis] = 1;
    direction[(cell->axis + 1) % 3] = u;
    direction[(cell->axis + 2) % 3] = v;
    double edge = 1.0 / ((double)cell->cells * strata), square = 1 + u * u + v * v;
    double angle = edge * edge / (square * sqrt(square));
    p->weight = scaled(light->brightness * (angle / (4 * pi)), light->color);
    photon_head_for(p, light->position, turned(direction, cell->octant));
}

/* The lamp's own light is for the backward tracer. */
static bool land(const photon *p, const meeting *at, sure_photon *landed)
{
    if (p->at_light || is_black(p->weight) || !sure_mixed_is_matte(at->material))
        return false;
    *landed = (sure_photon){
        .face = {at->nearest->object, at->side, at->part},
        .position = at->point,
        .weight = p->weight,
        .length = p->length,
    };
    return true;
}

/* A share by chance; but for the first surface, whose matte part is of no interest, by weight. */
static bool is_mirrored(photon *p, double mirror)
{
    if (!p->at_light)
        return random_fraction(&p->random) < mirror;
    p->weight = scaled(mirror, p->weight);
    return true;
}

typedef enum { TRAVELS, LANDED, LOST } fate;

static fate travel(photon *p, sure_photon *landed)
{
    sure_nearest nearest;
    if (!photon_nearest(p, &nearest))
        return LOST;
    meeting at = photon_meet(p, &nearest);
    double mirror = at.material->mirror;
    if (meeting_is_clear(&at))
        return photon_pass_clear(p, &at) && !is_black(p->weight) ? TRAVELS : LOST;
    /* What the last mirror would send on is lost: its matte part gets no more for that. */
    if (mirror > 0 && is_mirrored(p, mirror))
        return photon_reflect(p, &at) ? TRAVELS : LOST;
    return land(p, &at, landed) ? LANDED : LOST;
}

int sure_mixed_photon(const sure_scene *scene, sure_tier tier, const sure_mixed_cell *cell,
                      uint32_t strata, uint32_t number, uint64_t seed, sure_photon *landed)
{
    assert(cell->light < scene->light_count && number < (uint64_t)strata * strata);
    assert(strata >= 1 && strata <= 65536 && cell->cells > 0 &&
           (cell->cells & (cell->cells - 1)) == 0);
    assert(cell->axis >= 0 && cell->axis < 3 && cell->octant >= 0 && cell->octant < 8);
    assert(cell->column >= 0 && cell->column < cell->cells);
    assert(cell->row >= 0 && cell->row < cell->cells);
    photon p = {
        .t = {scene, tier, NULL, NULL},
        .random = random_stream_of(seed, RANDOM_CAUSTIC, number_of(cell, number)),
        .at_light = true,
        .chain_left = scene->depth,
    };
    fate end = TRAVELS;
    leave_light(&p, &scene->lights[cell->light], cell, strata, number);
    while (end == TRAVELS)
        end = travel(&p, landed);
    return end == LANDED;
}

/* SPDX-License-Identifier: MIT */
#include "setting.h"

#include "../../cases/shapes/case_shape.h"
#include "../../geometry/coordinate.h"

#include <math.h>

/* So thin, and so grazing, is a walk's place at most and at least. */
enum { THINNEST = -24, THICKEST = -4 };

#define NAME(KIND, name) name,
const char *const walk_kind_names[] = {EACH_WALK_KIND(NAME) NULL};
#undef NAME

bool walk_kind_applies(sure_shape shape, walk_kind kind)
{
    return sure_shape_info_of(shape)->solid &&
           (kind != WALK_THIN || case_shape_has(shape, CASE_HAS_HEIGHT));
}

static void make_thin(layout *lay, rng *g)
{
    double share = rng_magnitude(g, THINNEST, THICKEST);
    if (rng_chance(g, 1, 2))
        lay->h = share * lay->r;
    else
        lay->r = share * lay->h;
}

/* In whole numbers, so that nothing is rounded; about as large as 2^-2 to 2^3. */
static pose whole_pose(const layout *lay, rng *g)
{
    double q[4] = {1, 0, 0, 0};
    for (int i = 0; i < 4 && rng_chance(g, 3, 4); i++)
        q[i] = rng_integer(g, 1, 3);
    pose where = pose_turned(lay->shape, q);
    double reach = where.stretch * case_shape_of(lay->shape)->reach(lay);
    where.scale = rng_integer(g, -2, 3) - ilogb(reach);
    return where;
}

static double random_far(int reach, rng *g)
{
    double sign = rng_sign(g);
    int most = reach + 40 < 51 ? reach + 40 : 51;
    return sign * floor(rng_magnitude(g, reach + 10, most));
}

static void move_far(pose *where, const layout *lay, rng *g)
{
    int reach = ilogb(where->stretch * case_shape_of(lay->shape)->reach(lay));
    for (int i = 0; i < 3; i++)
        *coordinate_of(&where->move, i) = random_far(reach, g);
}

/* Every point goes to P + by (point - P). */
static sure_object stretched_from(sure_vec3 p, double by, const sure_object *object)
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    sure_case to = {.object = *object};
    for (int i = 0; i < info->field_count; i++) {
        const int at = AT_OBJECT + info->fields[i].at;
        sure_vec3 *point = case_vector(&to, at);
        if (info->fields[i].kind == SURE_KIND_RADIUS)
            *case_number(&to, at) *= by;
        else
            *point = sum_of(p, by, difference_of(*point, p));
    }
    object_mend(object->shape, case_number(&to, AT_OBJECT));
    return to.object;
}

static bool is_on(const sure_object *object, sure_vec3 p)
{
    const sure_ray point = {p, {1, 0, 0}, 0, 0};
    return sure_object_occluded(&point, object, SURE_TIER_EXACT) == SURE_HIT;
}

static double random_stretch(walk_kind kind, rng *g)
{
    return kind == WALK_NESTED  ? ldexp(1, rng_integer(g, -4, -1))
           : kind == WALK_SHELL ? 1 - ldexp(1, rng_integer(g, -20, -8))
                                : -1;
}

static sure_vec3 place_start(layout *lay, const pose *where, rng *g)
{
    lay->p = case_shape_of(lay->shape)->inner(lay, g);
    return place(lay, where).ray.origin;
}

static setting one_solid(sure_shape shape, walk_kind kind, bool far, rng *g)
{
    layout lay = random_body(shape, g, -2, 3);
    if (kind == WALK_THIN)
        make_thin(&lay, g);
    pose where = pose_general(shape, g, 3);
    if (far)
        move_far(&where, &lay, g);
    setting made = {.solids[0] = place(&lay, &where).object, .count = 1};
    made.start = place_start(&lay, &where, g);
    return made;
}

/* The second solid is the first one, stretched from a point of its boundary; drawn anew where that
 * is not its own for roundings. */
static setting two_solids(sure_shape shape, walk_kind kind, bool far, rng *g)
{
    setting made = {.count = WALK_SOLIDS};
    layout lay;
    pose where;
    sure_case touch;
    do {
        lay = surface_layout(shape, g);
        where = whole_pose(&lay, g);
        if (far)
            move_far(&where, &lay, g);
        touch = place(&lay, &where);
        made.solids[0] = touch.object;
        made.solids[1] = stretched_from(touch.ray.origin, random_stretch(kind, g), &touch.object);
    } while (!is_on(&made.solids[0], touch.ray.origin) ||
             !is_on(&made.solids[1], touch.ray.origin));
    made.start = place_start(&lay, &where, g);
    return made;
}

setting setting_of(sure_shape shape, walk_kind kind, rng *g)
{
    walk_kind placed = kind;
    if (kind >= WALK_FAR)
        placed = rng_chance(g, 1, 2) ? WALK_ALONE : rng_chance(g, 1, 2) ? WALK_NESTED : WALK_BESIDE;
    bool two = placed >= WALK_NESTED;
    return (two ? two_solids : one_solid)(shape, placed, kind == WALK_FAR, g);
}

/* SPDX-License-Identifier: MIT */
/* From p, the hit point correctly rounded, to a neighbour that is on the side asked for. The true
 * hit point P is in a plane that has the whole solid on one side, with the outward normal n. The
 * next double q_i of p_i towards n_i lies beyond P_i, which rounds to p_i, so the corner q has
 *
 *     n.(q - P) = sum of n_i (q_i - P_i) > 0
 *
 * over all i with n_i not 0: one step in every coordinate leads out. Fewer do in most cases, and
 * are tried before; inside, where a solid may be thinner than the doubles lie apart, and where n is
 * known too badly, the box of all neighbours is tried. Every point is tested exactly. */
#include <surehit/spawn.h>

#include "../../numbers/environment.h"
#include "../../numbers/valid.h"
#include "../close.h"
#include "../query.h"
#include "../rows.h"
#include "beyond.h"

#include <surehit/bounds.h>

#include <assert.h>
#include <stdlib.h>

typedef struct {
    const shape_row *row;
    const void *shape;
    sure_part part;
    int wanted; /* the side, as surface.h counts */
    double p[3];
    double origin[3]; /* the candidate */
} search;

static sure_vec3 vector_at(const double p[3])
{
    return (sure_vec3){p[0], p[1], p[2]};
}

/* A direction of the outward normal, so far as doubles tell, scaled where that helps (query.h). It
 * decides what is tried first, which spawn_quick.h foresees by its roundings as
 * docs/proofs/spawn.md counts them. */
static sure_vec3 outward(const search *s)
{
    sure_ray through = {vector_at(s->p), {1, 0, 0}, 0, 0};
    query q;
    (void)query_of(&through, s->row, s->shape, &q);
    return s->row->surface->outward(q.shape, s->part, q.ray->origin);
}

/* The double that lies `steps` away from x in the order of doubles; false where that is none. */
static bool stepped(double x, int steps, double *result)
{
    *result = at_place(place_of(x) + steps);
    return is_finite_bits(*result);
}

/* Entry: a finite point, round to nearest. */
static int side_of(const search *s, sure_vec3 p)
{
    assert(environment_is_nearest() && all_finite(p));
    int side;
    sure_stage unused;
    return query_side(s->row, s->shape, p, &side, &unused) ? side
                                                           : query_side_exact(s->row, s->shape, p);
}

static bool succeeds(search *s, const int steps[3])
{
    for (int i = 0; i < 3; i++) {
        if (!stepped(s->p[i], steps[i], &s->origin[i]))
            return false;
    }
    return side_of(s, vector_at(s->origin)) == s->wanted;
}

/* +-1 in every coordinate towards the side, and the coordinate in which one step leads farthest
 * along the normal: the greatest |n_i| 2^(exponent of p_i). */
static int directions(const search *s, int towards[3])
{
    sure_vec3 normal = outward(s);
    const double n[3] = {normal.x, normal.y, normal.z};
    int exponents[3], highest = -1023, best = 0;
    double most = -1;
    for (int i = 0; i < 3; i++) {
        exponents[i] = exponent_of(s->p[i]);
        highest = exponents[i] > highest ? exponents[i] : highest;
    }
    for (int i = 0; i < 3; i++) {
        int lower = exponents[i] - highest;
        double reach = fabs(n[i]) * power_of_two(lower < -1022 ? -1022 : lower);
        towards[i] = n[i] > 0 ? s->wanted : n[i] < 0 ? -s->wanted : 0;
        if (reach > most) {
            most = reach;
            best = i;
        }
    }
    return best;
}

/* All of the box, the fewest steps first. */
static bool search_box(search *s)
{
    const int most = SURE_SPAWN_STEPS;
    for (int all = 1; all <= 3 * most; all++) {
        for (int x = -most; x <= most; x++) {
            for (int y = -most; y <= most; y++) {
                int z = all - abs(x) - abs(y);
                if (z < 0 || z > most)
                    continue;
                if (succeeds(s, (int[3]){x, y, z}) || (z > 0 && succeeds(s, (int[3]){x, y, -z})))
                    return true;
            }
        }
    }
    return false;
}

static bool search_all(search *s)
{
    int towards[3];
    if (succeeds(s, (int[3]){0, 0, 0}))
        return true;
    int best = directions(s, towards);
    for (int count = 1; count <= 2; count++) {
        int steps[3] = {0, 0, 0};
        steps[best] = count * towards[best];
        if (succeeds(s, steps))
            return true;
    }
    return succeeds(s, towards) || search_box(s);
}

static NOT_INLINED bool spawn(const sure_ray *ray, const shape_row *row, const void *shape,
                              const sure_hit *hit, int side, sure_vec3 *origin)
{
    sure_vec3 p;
    if (!interaction_point(row, ray, shape, hit, &p))
        p = rounded_point(ray, row, shape);
    search s = {
        .row = row, .shape = shape, .part = hit->part, .wanted = side, .p = {p.x, p.y, p.z}};
    if (!search_all(&s))
        return false;
    *origin = vector_at(s.origin);
    return true;
}

/* By doubles with proven bounds; once more where the hit's t is then known better. */
static bool spawn_quick(const sure_ray *ray, const sure_object *object, const sure_hit *hit,
                        int side, sure_vec3 *origin)
{
    sure_hit nearer = {.t_error = -1}, unused;
    spawning *quick = close_of(row_of(object))->spawn;
    return quick(ray, &object->as, hit, side, origin, &nearer) ||
           (nearer.t_error >= 0 && quick(ray, &object->as, &nearer, side, origin, &unused));
}

int sure_spawn(const sure_ray *ray, const sure_object *object, const sure_hit *hit, sure_side side,
               sure_vec3 *origin)
{
    assert(sure_object_check(ray, object) == SURE_FIELD_NONE && hit_in_range(ray, hit));
    const shape_row *row = row_of(object);
    const void *shape = &object->as;
    int wanted = side == SURE_SIDE_INSIDE ? -1 : 1;
    if (wanted < 0 && row->surface->has_inside && !row->surface->has_inside(shape))
        return 0;
    if (environment_is_nearest() && spawn_quick(ray, object, hit, wanted, origin))
        return 1;
    environment saved;
    environment_enter(&saved); /* so that what is tried first is the same in every one */
    bool found = spawn(ray, row, shape, hit, wanted, origin);
    environment_leave(&saved);
    return found;
}

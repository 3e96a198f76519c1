/* SPDX-License-Identifier: MIT */
/* The regime camera: its rays are the tracer's, its objects those that a hierarchy asks. */
#include "suite.h"

#include "meeting.h"
#include "regimes.h"
#include "regimes_camera.h"
#include "regimes_layout.h"
#include "test_shape.h"

enum { CASES = 3000, SEED = 3 };

static camera_case made(int shape, int index)
{
    rng g = regime_rng((sure_shape)shape, REGIME_CAMERA, SEED, (uint64_t)index);
    return camera_case_of((sure_shape)shape, &g);
}

static double length(sure_vec3 v)
{
    return sqrt(dot(v, v));
}

static bool same(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

static bool same_object(const sure_object *a, const sure_object *b)
{
    return a->shape == b->shape &&
           same(&a->as, &b->as, sizeof(double) * (size_t)sure_shape_info_of(a->shape)->numbers);
}

SHAPE_TEST(every_shape_is_in_a_picture)
{
    ck_assert(camera_shows((sure_shape)_i));
    ck_assert(regime_applies((sure_shape)_i, REGIME_CAMERA));
    for (int i = 0; i < 100; i++) {
        camera_case c = made(_i, i);
        sure_case of_regime = regime_case((sure_shape)_i, REGIME_CAMERA, SEED, (uint64_t)i);
        ck_assert(same(&c.question.ray, &of_regime.ray, sizeof c.question.ray));
        ck_assert(same_object(&c.question.object, &of_regime.object));
    }
}

/* Law 1, to a fortieth of the cases. */
SHAPE_TEST(shares_of_kinds)
{
    int of[SURE_RAY_KINDS] = {0};
    for (int i = 0; i < CASES; i++)
        of[made(_i, i).kind]++;
    const int expected[SURE_RAY_KINDS] = {CASES / 2, CASES / 4, CASES / 8, CASES / 8};
    for (int kind = 0; kind < SURE_RAY_KINDS; kind++)
        ck_assert_msg(abs(of[kind] - expected[kind]) < CASES / 40, "%s: %d",
                      sure_ray_kind_name((sure_ray_kind)kind), of[kind]);
}

/* Every picture that has the shape is as likely for pixels' rays, to a third. */
SHAPE_TEST(shares_of_pictures)
{
    int of[64] = {0}, pixels = 0, pictures = 0;
    for (int i = 0; i < CASES; i++) {
        camera_case c = made(_i, i);
        pixels += c.kind == SURE_RAY_PIXEL;
        of[c.pixel.of - camera_pictures] += c.kind == SURE_RAY_PIXEL;
    }
    for (int k = 0; k < camera_picture_count; k++)
        pictures += camera_has_shape(&camera_pictures[k], (sure_shape)_i);
    ck_assert_int_gt(pictures, 0);
    for (int k = 0; k < camera_picture_count; k++) {
        const camera_picture *picture = &camera_pictures[k];
        int share = camera_has_shape(picture, (sure_shape)_i) ? pixels / pictures : 0;
        ck_assert_msg(abs(of[k] - share) <= share / 3, "%s: %d of %d", picture->name, of[k],
                      pixels);
    }
}

/* Law 2. */

typedef struct {
    tracing t;
    const camera_case *c;
} check;

/* The tracer's next ray of that kind, to that light; false where it has none. */
static bool next(const check *at, const sure_ray *ray, const sure_surface_point *leaving,
                 sure_ray_kind kind, size_t light, sure_ray *on, sure_surface_point *from)
{
    sure_nearest nearest;
    if (sure_backward_nearest(at->t.scene, at->t.tier, ray, leaving, &nearest) != SURE_HIT)
        return false;
    meeting met;
    meeting_of(&at->t, ray, leaving, &nearest, &met);
    bool clear = kind == SURE_RAY_REFRACTED;
    parting into = {1, {0, 0, 0}};
    if (clear && meeting_is_clear(&met))
        into = meeting_part(&met);
    bool goes_on = kind == SURE_RAY_MIRROR ? met.material->mirror > 0 : into.share < 1 || !clear;
    if (!goes_on || !meeting_leave(&at->t, &met, clear ? meeting_beyond(&met) : met.side, from))
        return false;
    *on = (sure_ray){from->point, clear ? into.direction : meeting_reflect(&met), 0, INFINITY};
    if (kind == SURE_RAY_SHADOW) {
        sure_vec3 to = at->t.scene->lights[light].position;
        bool lit = sure_light_intensity_textbook(met.point, met.normal, to) > 0;
        on->direction =
            (sure_vec3){to.x - from->point.x, to.y - from->point.y, to.z - from->point.z};
        on->t_max = nextafter(1, 0);
        return lit;
    }
    return true;
}

/* Is the case's ray one that follows, to any light? */
static bool follows(const check *at, const sure_ray *ray, const sure_surface_point *leaving,
                    sure_surface_point *from)
{
    bool found = false;
    for (size_t light = 0; light < at->t.scene->light_count && !found; light++) {
        sure_ray on;
        found = next(at, ray, leaving, at->c->kind, light, &on, from);
        on.t_min = at->c->question.ray.t_min; /* Law 3 says what it is */
        found = found && same(&on, &at->c->question.ray, sizeof on);
    }
    return found;
}

/* And which surface has it left? */
static bool is_traced(const camera_case *c, sure_surface_point *from)
{
    const check at = {{&c->pixel.of->scene, SURE_TIER_EXACT, NULL, NULL}, c};
    sure_ray on, ray = camera_pixel_ray(c->pixel.of, c->pixel.finer, c->pixel.column, c->pixel.row);
    sure_surface_point over;
    *from = (sure_surface_point){.object = SIZE_MAX};
    if (c->kind == SURE_RAY_PIXEL) /* what the eye touches is not in front of it */
        return same(&ray, &c->question.ray, sizeof ray) && ray.t_min == nextafter(0, 1);
    bool found = follows(&at, &ray, NULL, from);
    for (sure_ray_kind kind = SURE_RAY_MIRROR; kind <= SURE_RAY_REFRACTED && !found; kind++)
        found = next(&at, &ray, NULL, kind, 0, &on, &over) && follows(&at, &on, &over, from);
    return found;
}

SHAPE_TEST(rays_are_the_tracers)
{
    for (int i = 0; i < CASES; i++) {
        camera_case c = made(_i, i);
        sure_surface_point from;
        ck_assert_msg(is_traced(&c, &from), "%s, a %s ray: %s", c.pixel.of->name,
                      sure_ray_kind_name(c.kind), case_text(&c.question));
    }
}

/* A pixel of one of the windows, of any size; of what is everywhere a fifth in each. */
SHAPE_TEST(pixels_are_in_windows)
{
    int of[4] = {0}, sizes[CAMERA_FINEST + 1] = {0};
    for (int i = 0; i < CASES; i++) {
        const camera_pixel p = made(_i, i).pixel;
        const camera_picture *picture = p.of;
        int right = 2 * p.column >= p.finer * picture->scene.width;
        int up = 2 * p.row >= p.finer * picture->scene.height;
        int column = p.column / p.finer - picture->scene.width * (1 + 2 * right) / 4;
        int row = p.row / p.finer - picture->scene.height * (1 + 2 * up) / 4;
        ck_assert(2 * column >= -picture->columns && 2 * column < picture->columns);
        ck_assert(2 * row >= -picture->rows && 2 * row < picture->rows);
        of[right + 2 * up]++;
        sizes[p.finer]++;
    }
    bool everywhere = !sure_shape_info_of((sure_shape)_i)->bounded;
    for (int i = 0; i < 4 && everywhere; i++)
        ck_assert_int_gt(of[i], CASES / 5);
    for (int i = 1; i <= CAMERA_FINEST; i++)
        ck_assert_int_gt(sizes[i], CASES / 20);
}

/* Law 3. */

static bool passes(const sure_ray *ray, const sure_bounds *b)
{
    sure_object box = {
        SURE_SHAPE_BOX,
        {.box = {{b->low[0], b->low[1], b->low[2]}, {b->high[0], b->high[1], b->high[2]}}}};
    sure_interval unused;
    return !isfinite(b->low[0]) ||
           sure_object_interval(ray, &box, SURE_TIER_EXACT, &unused) == SURE_HIT;
}

static bool is_asked(const camera_case *c, size_t object, const sure_surface_point *from)
{
    sure_object shown[2];
    sure_bounds box;
    const sure_object *asked = &c->question.object, *whole = &c->pixel.of->scene.objects[object];
    int count = camera_shown_by(whole, asked->shape, shown);
    bool found = false;
    for (int i = 0; i < count; i++)
        found = found || same_object(&shown[i], asked);
    bool of_cap = asked->shape != whole->shape && sure_bvh_box(asked, &box);
    double begin = c->kind == SURE_RAY_PIXEL ? 0x1p-1074 : 0;
    if (found && object == from->object && !of_cap) {
        sure_ray ray = c->question.ray;
        sure_interval chord;
        ray.t_min = 0;
        ck_assert_int_eq(sure_object_interval(&ray, whole, SURE_TIER_EXACT, &chord), SURE_HIT);
        begin = chord.t_leave / 2 <= ray.t_max ? chord.t_leave / 2 : 0;
    }
    return found && (object != from->object || from->inside) && c->question.ray.t_min == begin &&
           passes(&c->question.ray, of_cap ? &box : &c->pixel.of->boxes[object]);
}

SHAPE_TEST(objects_are_those_that_a_hierarchy_asks)
{
    int within = 0, hits = 0;
    for (int i = 0; i < CASES; i++) {
        camera_case c = made(_i, i);
        sure_surface_point from;
        sure_hit hit;
        bool found = false;
        ck_assert(is_traced(&c, &from));
        for (size_t k = 0; k < c.pixel.of->scene.object_count && !found; k++)
            found = is_asked(&c, k, &from);
        ck_assert_msg(found, "%s: %s", c.pixel.of->name, case_text(&c.question));
        within += c.kind != SURE_RAY_PIXEL && from.inside;
        hits +=
            sure_object_hit(&c.question.ray, &c.question.object, SURE_TIER_EXACT, &hit) == SURE_HIT;
    }
    ck_assert_int_gt(within, CASES / 40);
    ck_assert(4 * hits > CASES && 5 * hits < 4 * CASES);
    printf("%s: %.1f %% hit\n", sure_shape_name((sure_shape)_i), 100.0 * hits / CASES);
}

/* A leaf's box holds its objects. */
TEST(boxes_hold_their_objects)
{
    int bounded = 0;
    for (int i = 0; i < camera_picture_count; i++) {
        const camera_picture *picture = &camera_pictures[i];
        for (size_t k = 0; k < picture->scene.object_count; k++) {
            sure_bounds own, leaf = picture->boxes[k];
            bool finite = isfinite(leaf.low[0]);
            bounded += finite;
            ck_assert(sure_bvh_box(&picture->scene.objects[k], &own) || !finite);
            for (int axis = 0; axis < 3 && finite; axis++)
                ck_assert(leaf.low[axis] <= own.low[axis] && own.high[axis] <= leaf.high[axis]);
        }
    }
    ck_assert_int_gt(bounded, 100);
}

/* Neighbouring pixels' rays are a pixel apart; their directions have, of components up to 1, their
 * last bits, and a pixel is at least 2^-14 wide. */
#define OF_A_PIXEL 0x1p-36

SHAPE_TEST(lengths_are_the_pictures)
{
    for (int i = 0; i < CASES; i++) {
        camera_case c = made(_i, i);
        camera_lengths by = camera_lengths_of(&c);
        const camera_pixel *p = &c.pixel;
        int aside = p->column > 0 ? p->column - 1 : p->column + 1;
        sure_vec3 d = camera_pixel_ray(p->of, p->finer, p->column, p->row).direction;
        sure_vec3 other = camera_pixel_ray(p->of, p->finer, aside, p->row).direction;
        double wide = length(difference_of(other, d)) / length(d);
        ck_assert_double_eq_tol(by.pixel, wide, OF_A_PIXEL * wide);
        ck_assert(by.way == c.way && by.speed == length(c.question.ray.direction));
        ck_assert((c.kind == SURE_RAY_PIXEL) == (by.way == 0));
        if (strcmp(p->of->name, "inside") == 0) /* a ball of radius 4.5 about eye and all */
            ck_assert_double_eq_tol(by.extent, 9 * sqrt(3), 0x1p-36);
        if (strcmp(p->of->name, "falloff") == 0) /* from the cone's base to the eye */
            ck_assert_double_eq_tol(by.extent, length((sure_vec3){6.7, 3, 10}), 0x1p-36);
    }
}

/* A cap as a disc is where the body's own cap is: a ray through its middle meets both there. */
SHAPE_TEST(caps_are_the_bodies)
{
    int caps = 0;
    for (int i = 0; i < CASES; i++) {
        camera_case c = made(_i, i);
        sure_object disc[2];
        int count =
            _i == SURE_SHAPE_DISC ? 0 : camera_shown_by(&c.question.object, SURE_SHAPE_DISC, disc);
        for (int k = 0; k < count; k++) {
            sure_disc d = disc[k].as.disc;
            sure_vec3 n = d.normal;
            sure_ray onto = {{d.centre.x + n.x, d.centre.y + n.y, d.centre.z + n.z},
                             {-n.x, -n.y, -n.z},
                             0,
                             INFINITY};
            sure_hit body, cap;
            ck_assert_int_eq(sure_object_hit(&onto, &disc[k], SURE_TIER_EXACT, &cap), SURE_HIT);
            ck_assert_int_eq(sure_object_hit(&onto, &c.question.object, SURE_TIER_EXACT, &body),
                             SURE_HIT);
            ck_assert(cap.t - body.t <= SURE_T_ERROR_CAP && body.t - cap.t <= SURE_T_ERROR_CAP);
            ck_assert(body.part == SURE_PART_BASE || body.part == SURE_PART_TOP);
            caps++;
        }
    }
    ck_assert(caps > 0 || !shape_has((sure_shape)_i, SURE_KIND_OTHER_POINT));
}

SUITE("camera_rays")

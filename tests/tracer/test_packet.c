/* SPDX-License-Identifier: MIT */
/* What a packet of rays meets is what each of them meets alone, bit by bit: objects and rays of all
 * regimes with one another, so that many are uncertain, with and without a hierarchy, for every
 * number of rays and width of lanes, ties and the objects that rays leave among them. And whole
 * pixels: together the colours that they have alone. */
#include "../../src/cases/regimes.h"
#include "../../src/hierarchy/bvh_build.h"
#include "../../src/stages/hits/block.h"
#include "../../src/tracer/packet.h"
#include "../../src/tracer/visible.h"
#include "../support/small_scene.h"
#include "../support/suite.h"

#include <surehit/camera.h>

enum { SEED = 71, SCENES = 400, OBJECTS = 24, ROUNDS = 12 };

static const int widths[] = {2, 4, 8};

/* A scene, and rays that are hard for its objects. */
typedef struct {
    sure_object objects[OBJECTS];
    sure_ray rays[OBJECTS];
    sure_scene scene;
    sure_bvh bvh;
} stage;

/* How often it was as the test is for. */
static struct {
    int walks, met, missed, left, met_again, whole;
} seen;

static void make_stage(stage *on, rng *d, bool boxed)
{
    for (size_t i = 0; i < OBJECTS;) {
        const sure_shape shape = (sure_shape)rng_integer(d, 0, SURE_SHAPES - 1);
        const regime which = (regime)rng_integer(d, 0, REGIMES - 1);
        if (!regime_applies(shape, which))
            continue;
        const sure_case of = regime_case(shape, which, SEED, rng_bits(d) % 100000);
        if (sure_object_check(&of.ray, &of.object) != SURE_FIELD_NONE)
            continue;
        on->objects[i] = i > 0 && rng_chance(d, 1, 8) ? on->objects[i - 1] : of.object; /* ties */
        on->rays[i++] = of.ray;
    }
    on->scene = (sure_scene){.objects = on->objects, .object_count = OBJECTS};
    on->bvh = (sure_bvh){0};
    ck_assert(!boxed || bvh_build(on->objects, OBJECTS, 1, &on->bvh));
    on->scene.bvh = boxed ? &on->bvh : NULL;
}

/* One of the rays, or its neighbour, or one that leaves what another one meets. */
static sure_ray some_ray(const stage *on, rng *d, size_t first, sure_surface_point *from,
                         const sure_surface_point **leaving)
{
    const size_t i = rng_chance(d, 3, 4) ? first : (size_t)rng_integer(d, 0, OBJECTS - 1);
    sure_ray ray = on->rays[i];
    sure_nearest nearest;
    *leaving = NULL;
    if (rng_chance(d, 1, 2)) {
        ray.direction.x *= 1 + 0x1p-20 * rng_integer(d, -4, 4);
        ray.direction.y *= 1 + 0x1p-20 * rng_integer(d, -4, 4);
    }
    const int side = rng_integer(d, 0, 1);
    if (!rng_chance(d, 1, 3) ||
        sure_backward_nearest(&on->scene, SURE_TIER_CERTAIN, &ray, NULL, &nearest) != SURE_HIT)
        return ray;
    const sure_object *object = &on->objects[nearest.object];
    const bool solid = sure_shape_info_of(object->shape)->solid;
    *from = (sure_surface_point){.object = nearest.object, .inside = solid && side};
    if (!sure_spawn(&ray, object, &nearest.hit, side ? SURE_SIDE_INSIDE : SURE_SIDE_OUTSIDE,
                    &from->point))
        return ray;
    *leaving = from;
    ray.origin = from->point;
    ray.t_min = 0;
    return ray;
}

static bool same_hit(const sure_nearest *a, const sure_nearest *b)
{
    return a->object == b->object && memcmp(&a->hit.t, &b->hit.t, sizeof a->hit.t) == 0 &&
           memcmp(&a->hit.t_error, &b->hit.t_error, sizeof a->hit.t_error) == 0 &&
           a->hit.part == b->hit.part && a->hit.leaves == b->hit.leaves;
}

static void tally(const packet *rays, size_t i, sure_status met, const sure_nearest *nearest)
{
    const sure_surface_point *leaving = rays->leaving[i];
    seen.met += met == SURE_HIT;
    seen.missed += met != SURE_HIT;
    seen.left += leaving != NULL;
    seen.met_again += leaving && met == SURE_HIT && nearest->object == leaving->object;
}

static void check_packet(const stage *on, packet *rays, const sure_ray *alone)
{
    const packet_walks *walks = packet_walks_here();
    sure_nearest together[PACKET];
    const unsigned met = walks->nearest(&on->scene, rays, together);
    const unsigned any = walks->any(&on->scene, rays);
    ck_assert_uint_eq((met | any) >> rays->count, 0);
    for (size_t i = 0; i < rays->count; i++) {
        sure_nearest nearest;
        size_t object;
        const sure_status status = sure_backward_nearest(&on->scene, SURE_TIER_CERTAIN, &alone[i],
                                                         rays->leaving[i], &nearest);
        ck_assert_int_eq(status == SURE_HIT, met >> i & 1);
        ck_assert(status != SURE_HIT || same_hit(&nearest, &together[i]));
        ck_assert_int_eq(visible_any(&on->scene, SURE_TIER_CERTAIN, &alone[i], rays->leaving[i],
                                     NULL, &object) == SURE_HIT,
                         any >> i & 1);
        tally(rays, i, status, &nearest);
    }
    seen.walks++;
    seen.whole += rays->count == PACKET;
}

/* By width, with a hierarchy and without. */
LOOP_TEST(together_as_alone, 6)
{
    if (block_lanes_most(widths[_i / 2]) != widths[_i / 2])
        return; /* this processor has no such vectors */
    memset(&seen, 0, sizeof seen);
    for (int n = 0; n < SCENES; n++) {
        rng d = rng_of(SEED, 0, (uint64_t)_i, (uint64_t)n);
        stage on;
        make_stage(&on, &d, _i % 2);
        for (int round = 0; round < ROUNDS; round++) {
            const size_t count = (size_t)rng_integer(&d, 1, PACKET);
            const size_t first = (size_t)rng_integer(&d, 0, OBJECTS - 1);
            sure_surface_point from[PACKET];
            sure_ray alone[PACKET];
            packet rays = {.count = 0};
            for (size_t i = 0; i < count; i++) {
                const sure_surface_point *leaving;
                alone[i] = some_ray(&on, &d, first, &from[i], &leaving);
                packet_add(&rays, &alone[i].origin, &alone[i].direction, alone[i].t_min,
                           alone[i].t_max, leaving);
            }
            check_packet(&on, &rays, alone);
        }
        bvh_free(&on.bvh);
    }
    ck_assert_int_gt(seen.met, seen.walks / 4);
    ck_assert_int_gt(seen.missed, seen.walks / 4);
    ck_assert_int_gt(seen.left, seen.walks / 8);
    ck_assert_int_gt(seen.met_again, 20);
    ck_assert_int_gt(seen.whole, seen.walks / 16);
}

/* Windows of any size, cameras that look anywhere. */
LOOP_TEST(pixels_rays_as_alone, 3)
{
    rng d = rng_of(SEED, 1, 0, 0);
    if (block_lanes_most(widths[_i]) != widths[_i])
        return;
    for (int n = 0; n < 3000; n++) {
        const sure_vec3 view = rng_unit(&d), window = rng_unit(&d);
        sure_scene scene = {
            .width = rng_integer(&d, 1, 1 << rng_integer(&d, 0, 20)),
            .height = rng_integer(&d, 1, 1 << rng_integer(&d, 0, 20)),
            .camera = {rng_unit(&d), fabs(window.x) + 0x1p-20, fabs(window.y), fabs(window.z)}};
        const size_t count = (size_t)rng_integer(&d, 1, PACKET);
        int column[PACKET], row[PACKET];
        packet rays;
        (void)sure_camera_rotation_textbook(view, &scene.turn);
        for (size_t k = 0; k < count; k++) {
            column[k] = rng_integer(&d, 0, scene.width - 1);
            row[k] = rng_integer(&d, 0, scene.height - 1);
        }
        packet_walks_here()->pixels(&scene, count, column, row, &rays);
        ck_assert_uint_eq(rays.count, count);
        for (size_t k = 0; k < count; k++) {
            const sure_ray one = sure_scene_pixel_ray(&scene, column[k], row[k]);
            const sure_ray together = packet_ray(&rays, k);
            ck_assert_mem_eq(&one, &together, sizeof one);
            ck_assert_ptr_null(rays.leaving[k]);
        }
    }
}

/* Mirrors, glass, a plane that none bounds, a disc that the eye touches, a ball around all; lights,
 * two of them on objects. With a hierarchy and without. */
LOOP_TEST(pixels_together, 6)
{
    enum { SIDE = 31 };
    const sure_object objects[] = {
        plane(0, -1, 0, 0, 1, 0),
        {SURE_SHAPE_SPHERE, {.sphere = {{-0.5, 0, -4}, 1}}},
        {SURE_SHAPE_SPHERE, {.sphere = {{0.8, -0.4, -3}, 0.5}}},
        {SURE_SHAPE_CONE, {.cone = {{0.2, -1, -5}, {0.2, 2, -5}, 1}}},
        {SURE_SHAPE_DISC, {.disc = {{0, 0, 0}, {1, 2, 3}, 0.25}}},
        {SURE_SHAPE_SPHERE, {.sphere = {{0, 0, 0}, 9}}},
    };
    enum { COUNT = sizeof objects / sizeof *objects };
    const sure_material materials[] = {
        {.color = {1, 1, 1}, .mirror = 0.3},
        {.color = {1, 0.5, 0.2}, .specular = 0.5, .shine = 20},
        {.color = {1, 1, 1}, .refract = 1.5, .specular = 0.5, .shine = 20},
        {.color = {0.2, 0.5, 1}},
        {.color = {1, 1, 1}},
        {.color = {0.5, 0.5, 0.5}},
    };
    const sure_light lights[] = {{.position = {3, 4, 0}, .color = {1, 1, 1}, .brightness = 0.5},
                                 {.position = {-3, 2, 1}, .color = {1, 1, 1}, .brightness = 0.4},
                                 {.position = {1, 4, -8}, .color = {1, 1, 1}, .brightness = 0.3},
                                 {.position = {1, -1, -2}, .color = {1, 1, 1}, .brightness = 0.2}};
    sure_scene scene = looking(objects, materials, COUNT, lights, 4);
    sure_bvh bvh = {0};
    int column[SIDE * SIDE], row[SIDE * SIDE];
    sure_vec3 color[SIDE * SIDE];
    block_lanes_most(widths[_i / 2]);
    ck_assert(bvh_build(objects, COUNT, 1, &bvh));
    scene.bvh = _i % 2 ? &bvh : NULL;
    scene.ambient = (sure_vec3){0.1, 0.1, 0.1};
    scene.width = scene.height = SIDE;
    for (int i = 0; i < SIDE * SIDE; i++) {
        column[i] = i % SIDE;
        row[i] = i / SIDE;
    }
    sure_backward_pixels(&scene, SURE_TIER_CERTAIN, SIDE * SIDE, column, row, color);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const sure_vec3 one = sure_backward_pixel(&scene, SURE_TIER_CERTAIN, column[i], row[i]);
        ck_assert_mem_eq(&one, &color[i], sizeof one);
    }
    bvh_free(&bvh);
}

SUITE("packets")

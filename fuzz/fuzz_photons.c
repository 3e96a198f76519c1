/* SPDX-License-Identifier: MIT */
/* Light in small scenes: the ways of the forward tracer's photons and of the mixed tracer's, the
 * cells of directions in which an object is met, a pixel of the backward tracer's, and shadow. */

#include "moved_case.h"
#include "objects.h"
#include "shape_bytes.h"
#include "tiers.h"

#include <surehit/backward.h>
#include <surehit/forward.h>
#include <surehit/mixed.h>
#include <surehit/shadow.h>

FUZZ_TARGET("photons", fuzz_mutate_doubles)

enum { OBJECTS = 3, LIGHTS = 2, PHOTONS = 3, SIDE = 4 };

static const sure_ray any_ray = {{0, 0, 0}, {1, 0, 0}, 0, 0};

typedef struct {
    sure_object objects[OBJECTS];
    sure_material materials[OBJECTS];
    sure_light lights[LIGHTS];
    sure_scene scene;
} world;

/* Matte, a mirror in part or as a whole, or clear. */
static sure_material read_material(fuzz_bytes *bytes)
{
    uint8_t kind = fuzz_byte(bytes);
    sure_material m = {.color = fuzz_vector(bytes, fuzz_share)};
    if (kind % 4 == 1)
        m.mirror = 1;
    if (kind % 4 == 2)
        m.mirror = fuzz_share(bytes);
    if (kind % 4 == 3)
        m.refract = 1 + fuzz_share(bytes);
    return m;
}

static bool read_object(fuzz_bytes *bytes, sure_object *object)
{
    sure_case made;
    uint64_t draws = 0; /* always with smaller exponents */
    if (!fuzz_case(bytes, (sure_shape)(fuzz_byte(bytes) % SURE_SHAPES), &made))
        return false;
    fuzz_cheapen(&made, &draws);
    *object = made.object;
    return sure_object_check(&any_ray, object) == SURE_FIELD_NONE;
}

static void set_scene(world *w)
{
    w->scene.objects = w->objects;
    w->scene.materials = w->materials;
    w->scene.lights = w->lights;
}

static bool read_world(fuzz_bytes *bytes, uint8_t how, world *w)
{
    *w = (world){.scene = {.object_count = 1 + how % OBJECTS, .light_count = 1 + how / 4 % LIGHTS}};
    w->scene.falloff = how & 16 ? SURE_FALLOFF_NONE : SURE_FALLOFF_INVERSE_SQUARE;
    w->scene.depth = 1 + how / 32 % 4;
    w->scene.camera = (sure_camera){.position = fuzz_vector(bytes, fuzz_signed),
                                    .focal_length = 1,
                                    .viewport_width = 2,
                                    .viewport_height = 2};
    w->scene.width = w->scene.height = SIDE;
    for (size_t i = 0; i < w->scene.light_count; i++)
        w->lights[i] = (sure_light){fuzz_vector(bytes, fuzz_signed), fuzz_vector(bytes, fuzz_share),
                                    1 + fuzz_byte(bytes)};
    for (size_t i = 0; i < w->scene.object_count; i++) {
        w->materials[i] = read_material(bytes);
        if (!read_object(bytes, &w->objects[i]))
            return false;
    }
    set_scene(w);
    return true;
}

/* What the eye was told, to be compared. */
typedef struct {
    unsigned splats;
    sure_vec3 sum;
} film;

static void splat(void *to, int column, int row, sure_vec3 value)
{
    film *f = to;
    expect(column >= 0 && column < SIDE && row >= 0 && row < SIDE, "no such pixel");
    expect(all_finite(value) && value.x >= 0 && value.y >= 0 && value.z >= 0, "no light");
    f->splats++;
    f->sum = plus(f->sum, value);
}

static film shine(const world *w, sure_tier tier, const sure_forward_options *options,
                  uint64_t number, sure_forward_statistics *sum)
{
    film f = {0};
    sure_forward_photon(&w->scene, tier, options, number, splat, &f, sum);
    return f;
}

/* Laws 1 and 2 of forward.h. */
static void check_forward(const world *w, sure_tier tier, const sure_forward_options *options)
{
    for (uint64_t i = 0; i < PHOTONS; i++) {
        sure_forward_statistics sum = {0}, again = {0};
        film once = shine(w, tier, options, i, &sum), twice = shine(w, tier, options, i, &again);
        expect(memcmp(&sum, &again, sizeof sum) == 0 && once.splats == twice.splats &&
                   same_vector(once.sum, twice.sum),
               "Law 1: another way of the same photon");
        expect(sum.emitted == sum.escaped + sum.absorbed + sum.stopped + sum.entered &&
                   sum.emitted <= 1,
               "Law 2: a photon that does not end once");
        expect(once.splats <= sum.reached && sum.reached <= sum.through,
               "light that did not arrive");
    }
}

static sure_mixed_cell read_cell(fuzz_bytes *bytes, const world *w)
{
    uint8_t where = fuzz_byte(bytes);
    sure_mixed_cell cell = {.light = where % w->scene.light_count, .cells = 1 << where / 64 % 4};
    cell.axis = where / 2 % 3;
    cell.octant = fuzz_byte(bytes) % 8;
    cell.column = fuzz_byte(bytes) % cell.cells;
    cell.row = fuzz_byte(bytes) % cell.cells;
    return cell;
}

/* The scene 2^k times as large. */
static void enlarge(world *w, int k)
{
    const int powers[NUMBER_KINDS] = {[IS_LENGTH] = k};
    for (size_t i = 0; i < w->scene.object_count; i++) {
        sure_case of = {.ray = any_ray, .object = w->objects[i]}, made;
        (void)case_scaled(&of, powers, &made);
        w->objects[i] = made.object;
    }
    for (size_t i = 0; i < w->scene.light_count; i++)
        w->lights[i].position = times_two_to(w->lights[i].position, k);
}

/* Next to 0 lies the same double in both scenes. */
static bool is_eight_times(double far, double near)
{
    return far == 8 * near || (fabs(far) < 0x1p-900 && fabs(near) < 0x1p-900);
}

/* Are all of its numbers 0 or far from underflow, and the larger scene's from overflow? */
static bool is_ordinary(const world *w)
{
    for (size_t i = 0; i < w->scene.object_count; i++) {
        const double *numbers = (const double *)&w->objects[i].as;
        for (int n = 0; n < sure_shape_info_of(w->objects[i].shape)->numbers; n++) {
            double x = fabs(numbers[n]);
            if (x != 0 && (x < 0x1p-300 || x > 0x1p300))
                return false;
        }
    }
    return true;
}

/* Laws 2 and 4 of mixed.h, the latter of scaling. */
static void check_mixed(world *w, sure_tier tier, const sure_mixed_cell *cell, uint32_t strata)
{
    sure_photon landed = {.length = -1}, again = landed, far = landed;
    uint32_t number = strata * strata - 1;
    int there = sure_mixed_photon(&w->scene, tier, cell, strata, number, 1, &landed);
    int twice = sure_mixed_photon(&w->scene, tier, cell, strata, number, 1, &again);
    expect(there == twice && same_vector(landed.position, again.position) &&
               same_vector(landed.weight, again.weight) && landed.length == again.length,
           "Law 2: another way of the same photon");
    expect(there || landed.length == -1, "a photon written that did not arrive");
    expect(!there || (landed.length >= 0 && all_finite(landed.weight) && landed.weight.x >= 0),
           "a way or a weight that is none");
    if (tier < SURE_TIER_CERTAIN || !is_ordinary(w))
        return;
    world larger = *w;
    set_scene(&larger);
    enlarge(&larger, 3);
    twice = sure_mixed_photon(&larger.scene, tier, cell, strata, number, 1, &far);
    expect(there == twice && (!there || (is_eight_times(far.position.x, landed.position.x) &&
                                         is_eight_times(far.position.y, landed.position.y) &&
                                         is_eight_times(far.position.z, landed.position.z) &&
                                         landed.length == far.length / 8 &&
                                         same_vector(landed.weight, far.weight))),
           "Law 4: another photon in a larger scene");
}

/* Is it in the strip? */
static bool is_named(sure_mixed_strip strip, int place)
{
    return place >= strip.first && place <= strip.last;
}

/* Law 1 of mixed.h: a ray that meets the object is in a column and a row that are named; its
 * direction is a corner of the cell, moved into it. */
static void check_strips(const world *w, const sure_mixed_cell *cell, double inwards)
{
    double direction[3];
    direction[cell->axis] = 1;
    direction[(cell->axis + 1) % 3] = (cell->column + inwards) / cell->cells;
    direction[(cell->axis + 2) % 3] = (cell->row + inwards) / cell->cells;
    for (int i = 0; i < 3; i++)
        direction[i] *= cell->octant >> i & 1 ? -1 : 1;
    sure_vec3 light = w->lights[cell->light].position;
    sure_vec3 d = {direction[0], direction[1], direction[2]};
    const sure_ray ray = {light, d, 0, INFINITY};
    for (size_t i = 0; i < w->scene.object_count; i++) {
        const sure_object *o = &w->objects[i];
        if (coordinate(d, cell->axis) == 0 ||
            sure_object_occluded(&ray, o, SURE_TIER_CERTAIN) != SURE_HIT)
            continue;
        expect(is_named(sure_mixed_strip_of(o, light, cell->axis, cell->octant, 1, cell->cells),
                        cell->column) &&
                   is_named(sure_mixed_strip_of(o, light, cell->axis, cell->octant, 2, cell->cells),
                            cell->row),
               "Law 1: a ray is lost");
    }
}

/* Law 1 of backward.h, and that it is light; Law 1 of shadow.h: an object more never turns shadow
 * into light. */
static void check_backward(const world *w, sure_tier tier, uint8_t which)
{
    int column = which % SIDE, row = which / SIDE % SIDE;
    sure_vec3 seen = sure_backward_pixel(&w->scene, tier, column, row);
    expect(seen.x >= 0 && seen.y >= 0 && seen.z >= 0, "a colour that is none");
    expect(same_vector(seen, sure_backward_pixel(&w->scene, tier, column, row)),
           "Law 1: another colour of the same pixel");
    sure_vec3 light = w->lights[0].position;
    const sure_surface_point from = {0, w->scene.camera.position, {0, 0, 1}, 0};
    sure_scene fewer = w->scene;
    fewer.object_count--;
    if (fewer.object_count > 0 && light.z > from.point.z)
        expect(sure_shadow_reaches(&w->scene, tier, &from, light) <=
                   sure_shadow_reaches(&fewer, tier, &from, light),
               "Law 1: an object turns shadow into light");
}

static void tell(const world *w)
{
    char text[3 * CASE_LINE_MAX] = "";
    size_t size = 0;
    for (size_t i = 0; i < w->scene.object_count; i++) {
        sure_case object = {.ray = {w->lights[0].position, {1, 0, 0}, 0, INFINITY},
                            .object = w->objects[i]};
        case_print(&object, text + size);
        size = strlen(text);
        text[size++] = '\n';
        text[size] = '\0';
    }
    fuzz_ask("%s", text);
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    uint8_t how = fuzz_byte(&bytes), what = fuzz_byte(&bytes);
    sure_tier tier = (sure_tier)(what % SURE_TIERS);
    world w;
    if (!read_world(&bytes, how, &w))
        return false;
    sure_mixed_cell cell = read_cell(&bytes, &w);
    sure_forward_options options = {.seed = what, .bounces = 1 + what / 8 % 3};
    if (w.scene.falloff == SURE_FALLOFF_NONE)
        options.bounces = 1;
    options.aperture = what & 64 ? 4 : 0;
    tell(&w);
    fuzz_by(tier);
    check_forward(&w, tier, &options);
    check_mixed(&w, tier, &cell, 1 + what % 3);
    check_strips(&w, &cell, fuzz_share(&bytes));
    if (is_ordinary(&w)) /* no hit point overflows */
        check_backward(&w, tier, fuzz_byte(&bytes));
    return true;
}

/* SPDX-License-Identifier: MIT */
/* Photons that mirrors and glass send to matte surfaces: which directions they leave in, where they
 * land and what they bring, against truths that are known. Statistics are over seeds: a mean is as
 * far from the truth as Student's t allows with a false-alarm rate of 1e-6. */
#include "caustics.h"
#include "suite.h"
#include "test_shape.h"
#include "small_scene.h"
#include "surroundings.h"

#include <signal.h>

enum { SEEDS = 48, STREAM = 840 };
#define T_MOST 5.62 /* of 47 degrees of freedom */

static sure_object disc(sure_vec3 centre, sure_vec3 normal, double radius)
{
    return (sure_object){SURE_SHAPE_DISC, {.disc = {centre, normal, radius}}};
}

static const sure_material white = {.color = {1, 1, 1}};

/* Samples, and how far their mean may be from the truth. */
typedef struct {
    double value[SEEDS], mean, doubt;
} sample;

static void weigh(sample *s)
{
    double square = 0;
    s->mean = 0;
    for (int i = 0; i < SEEDS; i++)
        s->mean += s->value[i] / SEEDS;
    for (int i = 0; i < SEEDS; i++)
        square += (s->value[i] - s->mean) * (s->value[i] - s->mean);
    s->doubt = T_MOST * sqrt(square / (SEEDS - 1) / SEEDS);
}

/* `most_doubt`: the test must be able to tell as much. */
static void expect_mean(sample *s, double truth, double most_doubt, const char *what)
{
    weigh(s);
    ck_assert_msg(fabs(s->mean - truth) <= s->doubt, "%s: %g, not %g; in doubt by %g", what,
                  s->mean, truth, s->doubt);
    ck_assert_msg(s->doubt <= most_doubt * truth, "%s: %g is in doubt by %g", what, s->mean,
                  s->doubt);
}

/* Directions. */

/* The cell that a direction is in. */
static sure_mixed_cell cell_of(sure_vec3 d, int cells)
{
    sure_mixed_cell cell = {.cells = cells};
    for (int axis = 1; axis < 3; axis++) {
        if (fabs(coordinate(d, axis)) > fabs(coordinate(d, cell.axis)))
            cell.axis = axis;
    }
    for (int axis = 0; axis < 3; axis++)
        cell.octant |= (coordinate(d, axis) < 0) << axis;
    double whole = fabs(coordinate(d, cell.axis));
    cell.column = (int)(fabs(coordinate(d, (cell.axis + 1) % 3)) / whole * cells);
    cell.row = (int)(fabs(coordinate(d, (cell.axis + 2) % 3)) / whole * cells);
    cell.column = cell.column < cells ? cell.column : cells - 1;
    cell.row = cell.row < cells ? cell.row : cells - 1;
    return cell;
}

/* Columns and rows of the cells that are named on that face. */
typedef struct {
    sure_mixed_strip column, row;
} named;

static named named_of(const sure_object *object, sure_vec3 light, int axis, int octant, int cells)
{
    return (named){sure_mixed_strip_of(object, light, axis, octant, 1, cells),
                   sure_mixed_strip_of(object, light, axis, octant, 2, cells)};
}

static bool is_named(const sure_object *object, sure_vec3 light, const sure_mixed_cell *cell)
{
    named by = named_of(object, light, cell->axis, cell->octant, cell->cells);
    return cell->column >= by.column.first && cell->column <= by.column.last &&
           cell->row >= by.row.first && cell->row <= by.row.last;
}

static sure_vec3 random_vector(uint64_t stream, uint64_t i)
{
    return suite_doubles(STREAM + 3 * stream, i, 0);
}

static sure_object random_object(uint64_t i, double size)
{
    sure_vec3 at = random_vector(1, i), n = random_vector(2, i), far = plus(at, times(size, n));
    double radius = size * fabs(random_vector(3, i).x);
    static const sure_shape shapes[] = {SURE_SHAPE_SPHERE, SURE_SHAPE_DISC, SURE_SHAPE_CYLINDER,
                                        SURE_SHAPE_CONE};
    sure_shape shape = shapes[i % 4];
    return object_made(shape, at, n, far, radius);
}

/* A point of the object's surroundings, so that half of the rays there hit or so. */
static sure_vec3 towards(const sure_object *object, sure_vec3 light, uint64_t i)
{
    sure_bounds box;
    ck_assert(sure_bvh_box(object, &box));
    sure_vec3 low = {box.low[0], box.low[1], box.low[2]};
    sure_vec3 half = times(0.5, minus((sure_vec3){box.high[0], box.high[1], box.high[2]}, low));
    return minus(plus(plus(low, half), by_parts(half, random_vector(4, i))), light);
}

/* Law 1. Small, large and about the light, at every scale. */
TEST(no_ray_is_lost)
{
    static const int scales[] = {0, -300, 300, -900};
    int hits = 0, cells = 32;
    for (uint64_t i = 0; i < 3000; i++) {
        double by = ldexp(1, scales[i / 4 % 4]), size = by * ldexp(1, -(int)(i / 16 % 12));
        sure_object object = random_object(i, size / by);
        sure_vec3 light = random_vector(5, i);
        if (i % 20 == 0) /* in the middle of a ball */
            light = object.as.sphere.centre;
        for (uint64_t k = 0; k < 40; k++) {
            sure_vec3 way = towards(&object, light, 40 * i + k);
            sure_ray ray = {light, way, 0, INFINITY};
            sure_hit hit;
            sure_mixed_cell cell = cell_of(way, cells);
            if (sure_object_hit(&ray, &object, SURE_TIER_CERTAIN, &hit) != SURE_HIT)
                continue;
            hits++;
            ck_assert_msg(is_named(&object, light, &cell), "object %d, ray %d", (int)i, (int)k);
        }
    }
    ck_assert_int_gt(hits, 30000);
}

/* Nor among the least numbers, in any surroundings. From slope 3/4 on a ray reaches a ball that is
 * as far from one axis as its radius and twice that from the other. */
LOOP_TEST(no_ray_is_lost_among_the_least, SURROUNDINGS)
{
    const double u = 0x1p-1074;
    const sure_vec3 light = {0, 0, 0};
    for (int size = 1; size <= 8; size *= 2) {
        const sure_object beside = sphere(2 * size * u, 0, -size * u, size * u);
        const sure_object above = sphere(0, 2 * size * u, -size * u, size * u);
        surroundings_set(_i);
        sure_mixed_strip columns = sure_mixed_strip_of(&beside, light, 2, 4, 1, 256);
        sure_mixed_strip rows = sure_mixed_strip_of(&above, light, 2, 4, 2, 256);
        surroundings_set(0);
        ck_assert_msg(columns.first <= 192 && columns.last == 255, "%s: columns %d to %d",
                      surroundings_name(_i), columns.first, columns.last);
        ck_assert_msg(rows.first <= 192 && rows.last == 255, "%s: rows %d to %d",
                      surroundings_name(_i), rows.first, rows.last);
    }
}

SIGNAL_TEST(what_is_no_ball_has_no_cells, SIGABRT)
{
    const sure_object none = sphere(NAN, 0, 0, 1);
    (void)named_of(&none, (sure_vec3){0, 0, 0}, 0, 0, 32);
}

/* And few more are named than there are. */
TEST(what_is_far_has_few_cells)
{
    sure_object ball = sphere(10, 2, 3, 1);
    int all = 0, cells = 32;
    for (int face = 0; face < 24; face++) {
        named by = named_of(&ball, (sure_vec3){0, 0, 0}, face / 8, face % 8, cells);
        int columns = by.column.last - by.column.first + 1, rows = by.row.last - by.row.first + 1;
        int count = columns > 0 && rows > 0 ? columns * rows : 0;
        ck_assert(face == 0 || count == 0);
        all += count;
    }
    /* The ball reaches from (2 -+ 1)/(10 +- 1) at most, likewise in z: 1/11 to 3/9, 2/11 to 4/9. */
    ck_assert_int_ge(all, 4 * 5);
    ck_assert_int_le(all, (32 * 3 / 9 - 32 * 1 / 11 + 1) * (32 * 4 / 9 - 32 * 2 / 11 + 1));
}

TEST(a_plane_may_be_anywhere)
{
    const sure_object floor = plane(0, -1, 0, 0, 1, 0);
    for (int face = 0; face < 24; face++) {
        named by = named_of(&floor, (sure_vec3){0, 0, 0}, face / 8, face % 8, 8);
        ck_assert(by.column.first == 0 && by.column.last == 7);
        ck_assert(by.row.first == 0 && by.row.last == 7);
    }
}

/* All photons of all cells, and what is done with those that land. */
typedef void (*landing)(const sure_photon *photon, void *sum);

static void trace_all(const sure_scene *scene, int cells, uint32_t strata, uint64_t seed,
                      landing told, void *sum)
{
    sure_photon photon;
    for (size_t light = 0; light < scene->light_count; light++) {
        for (int face = 0; face < 24; face++) {
            for (int place = 0; place < cells * cells; place++) {
                const sure_mixed_cell cell = {light,         face / 8,      face % 8,
                                              place % cells, place / cells, cells};
                for (uint32_t i = 0; i < strata * strata; i++) {
                    if (sure_mixed_photon(scene, SURE_TIER_CERTAIN, &cell, strata, i, seed,
                                          &photon))
                        told(&photon, sum);
                }
            }
        }
    }
}

static void add_weight(const sure_photon *photon, void *sum)
{
    *(double *)sum += photon->weight.x;
}

/* The power that lands, of each seed. */
static sample power_of(const sure_scene *scene, int cells, uint32_t strata)
{
    sample s = {.mean = 0};
    for (int i = 0; i < SEEDS; i++)
        trace_all(scene, cells, strata, (uint64_t)i, add_weight, &s.value[i]);
    return s;
}

/* Law 3. A lamp above the middle of a round mirror, at its radius' height, in a large white ball:
 * (1 - cos 45 degrees) / 2 of its power meets the mirror, and the mirror's share of it is sent on
 * to the ball. */
LOOP_TEST(power_that_lands, 2)
{
    const sure_light lamp = {{0, 0, 1}, {0.5, 1, 1}, 8};
    const sure_object objects[] = {disc((sure_vec3){0, 0, 0}, (sure_vec3){0, 0, 1}, 1),
                                   sphere(0, 0, 0, 100)};
    const double mirror = _i ? 0.75 : 1;
    const sure_material materials[] = {{.color = {1, 1, 1}, .mirror = mirror}, white};
    const sure_scene scene = falling_off(objects, materials, 2, &lamp, 1);
    sample s = power_of(&scene, 4, 4);
    expect_mean(&s, 0.5 * 8 * mirror * (1 - sqrt(0.5)) / 2, 0.04, "power");
}

/* Law 3, where the depth ends the way. Between two mirrors half of the light meets either first;
 * the matte part of one mirror more gets its share, and not what would be sent on. */
LOOP_TEST(power_that_lands_at_the_depth, 2)
{
    const sure_light lamp = {{0, 0, 1}, {1, 1, 1}, 8};
    const sure_object objects[] = {plane(0, 0, 0, 0, 0, 1), plane(0, 0, 3, 0, 0, 1)};
    const sure_material materials[] = {{.color = {1, 1, 1}, .mirror = 0.75},
                                       {.color = {1, 1, 1}, .mirror = 0.5}};
    const double below = 0.75 * 0.5, above = 0.5 * 0.25, both = 0.75 * 0.5;
    const double share = _i ? below + both * 0.25 + above + both * 0.5 : below + above;
    sure_scene scene = falling_off(objects, materials, 2, &lamp, 1);
    scene.depth = 1 + _i;
    sample s = power_of(&scene, 4, 4);
    expect_mean(&s, 0.5 * 8 * share, 0.04, "power");
}

/* All directions that a lamp has, once each: what a clear ball about it lets through is all of its
 * light, since index 1 reflects nothing. */
static const sure_light in_the_ball = {{0.1, 0.2, -0.3}, {1, 1, 1}, 3};
static const sure_object clear_in_white[] = {{SURE_SHAPE_SPHERE, {.sphere = {{0, 0, 0}, 1}}},
                                             {SURE_SHAPE_SPHERE, {.sphere = {{0, 0, 0}, 5}}}};
static const sure_material clear_and_white[] = {{.color = {1, 1, 1}, .refract = 1},
                                                {.color = {1, 1, 1}}};

TEST(all_of_the_light)
{
    const sure_scene scene = falling_off(clear_in_white, clear_and_white, 2, &in_the_ball, 1);
    sample s = power_of(&scene, 2, 3);
    expect_mean(&s, 3, 0.01, "power");
}

/* Light on a spot. */
typedef struct {
    sure_vec3 centre;
    double radius, sum;
    sure_falloff falloff;
} spot;

static void add_on_spot(const sure_photon *photon, void *to)
{
    spot *on = to;
    sure_vec3 way = minus(photon->position, on->centre);
    double all = on->falloff == SURE_FALLOFF_NONE ? 4 * pi * photon->length * photon->length : 1;
    if (photon->face.object == 1 && dot(way, way) < on->radius * on->radius)
        on->sum += all * photon->weight.y;
}

/* Of each seed, on each unit of area. */
static sample light_on(const sure_scene *scene, spot *on, int cells, uint32_t strata)
{
    sample s = {.mean = 0};
    for (int i = 0; i < SEEDS; i++) {
        on->sum = 0;
        trace_all(scene, cells, strata, (uint64_t)i, add_on_spot, on);
        s.value[i] = on->sum / (pi * on->radius * on->radius);
    }
    return s;
}

/* The mean over the spot, in the plane y = 0, of what a lamp gives that is seen through something
 * of that share. */
typedef double (*passing)(sure_vec3 way);

static double mean_light(const spot *on, const sure_light *lamp, passing share)
{
    enum { RINGS = 60, PARTS = 90 };
    double sum = 0;
    for (int i = 0; i < RINGS; i++) {
        double r = on->radius * sqrt((i + 0.5) / RINGS); /* rings of one area */
        for (int k = 0; k < PARTS; k++) {
            double angle = 2 * pi * k / PARTS;
            sure_vec3 at = {on->centre.x + r * cos(angle), on->centre.y,
                            on->centre.z + r * sin(angle)};
            double cosine = sure_light_intensity_stable(at, (sure_vec3){0, 1, 0}, lamp->position);
            sum += cosine * sure_light_color_stable(lamp, at, on->falloff).y *
                   share(minus(at, lamp->position));
        }
    }
    return sum / (RINGS * PARTS);
}

static double all_of_it(sure_vec3 way)
{
    (void)way;
    return 1;
}

/* A mirror that stands on a floor sends it the light of the lamp's image. */
static const sure_object mirror_and_floor[] = {
    {SURE_SHAPE_DISC, {.disc = {{-1, 1, 0}, {1, 0, 0}, 3}}},
    {SURE_SHAPE_PLANE, {.plane = {{0, 0, 0}, {0, 1, 0}}}}};
static const sure_material mirror_and_white[] = {{.color = {1, 1, 1}, .mirror = 1},
                                                 {.color = {1, 1, 1}}};

/* A clear disc is a thin sheet that turns nothing aside: 1 - 2 F / (1 + F) in its colour. */
static double through_the_sheet(sure_vec3 way)
{
    double f = sure_refract_fresnel_stable(way, (sure_vec3){0, 1, 0}, 1 / 1.5);
    return (1 - 2 * f / (1 + f)) * 0.75;
}

TEST(a_thin_sheet_of_glass)
{
    const sure_light lamp = {{0, 2, 0}, {1, 1, 1}, 20};
    const sure_object objects[] = {disc((sure_vec3){0, 1, 0}, (sure_vec3){0, 1, 0}, 1),
                                   plane(0, 0, 0, 0, 1, 0)};
    const sure_material materials[] = {{.color = {1, 0.75, 1}, .refract = 1.5}, white};
    sure_scene scene = falling_off(objects, materials, 2, &lamp, 1);
    spot on = {.centre = {0.25, 0, 0}, .radius = 1.5, .falloff = scene.falloff};
    sample s = light_on(&scene, &on, 4, 3);
    expect_mean(&s, mean_light(&on, &lamp, through_the_sheet), 0.04, "light through glass");
}

/* What the eye sees of it is what is gathered: 1 / k less than there is, at most, and no more than
 * the light differs among the k nearest; times what a mirror leaves of a surface. */
static double pixel(sure_scene scene, const sure_photon_map *map, int column, int row)
{
    scene.caustics = map;
    return sure_backward_pixel(&scene, SURE_TIER_CERTAIN, column, row).y;
}

/* Of all pixels of a picture of the plane z = -4 the mean share of what the image of a lamp gives
 * there. */
static double seen_of_image(const sure_scene *scene, const sure_photon_map *map,
                            const sure_light *image)
{
    double sum = 0;
    for (int i = 0; i < scene->width * scene->height; i++) {
        int column = i % scene->width, row = i / scene->width;
        sure_vec3 d = sure_scene_pixel_ray(scene, column, row).direction;
        sure_vec3 at = {-4 * d.x / d.z, -4 * d.y / d.z, -4}, up = {0, 0, 1};
        double light = sure_light_color_stable(image, at, scene->falloff).y *
                       sure_light_intensity_stable(at, up, image->position);
        sum += (pixel(*scene, map, column, row) - pixel(*scene, NULL, column, row)) / light;
    }
    return sum / (scene->width * scene->height);
}

static caustics_statistics build(const sure_scene *scene, integrator_kind kind, uint64_t photons,
                                 int seed, sure_photon_map *map)
{
    const render_settings how = {.how = {.tier = SURE_TIER_CERTAIN, .threads = 1},
                                 .integrator = kind,
                                 .photons = photons,
                                 .seed = (uint64_t)seed};
    return caustics_build(scene, &how, map);
}

static sure_photon_map map_of(const sure_scene *scene, uint64_t count, int seed)
{
    sure_photon_map map;
    ck_assert_int_eq(build(scene, INTEGRATOR_MIXED, count, seed, &map).state, CAUSTICS_ON);
    return map;
}

/* Law 4: photon by photon. */
TEST(mirrored_photons)
{
    const sure_material glass = {.color = {1, 0.9, 0.8}, .refract = 1.5};
    const sure_material half = {.color = {1, 1, 1}, .mirror = 0.5};
    const sure_material materials[] = {glass, half, white};
    int landed = 0;
    for (int axis = 0; axis < 3; axis++) {
        const sure_vec3 by = mirror_of(axis), lamp_at = {0.5, 3, 0.25};
        const sure_light lamps[] = {{lamp_at, {1, 1, 1}, 1}, {by_parts(by, lamp_at), {1, 1, 1}, 1}};
        const sure_object objects[2][3] = {
            {sphere(0.25, 1, 0.5, 0.75), sphere(-1, 1, 0.5, 0.5), sphere(0, 0, 0, 6)},
            {sphere(0.25 * by.x, by.y, 0.5 * by.z, 0.75), sphere(-by.x, by.y, 0.5 * by.z, 0.5),
             sphere(0, 0, 0, 6)}};
        const sure_scene scenes[] = {falling_off(objects[0], materials, 3, &lamps[0], 1),
                                     falling_off(objects[1], materials, 3, &lamps[1], 1)};
        for (int i = 0; i < 24 * 64; i++) {
            sure_mixed_cell cell = {0, i % 3, i / 3 % 8, i / 24 % 8, i / 192, 8};
            sure_photon at, other;
            int found = sure_mixed_photon(&scenes[0], SURE_TIER_CERTAIN, &cell, 3, 7, 1, &at);
            cell.octant ^= 1 << axis;
            ck_assert_int_eq(
                sure_mixed_photon(&scenes[1], SURE_TIER_CERTAIN, &cell, 3, 7, 1, &other), found);
            if (!found)
                continue;
            landed++;
            ck_vector_same(other.position, by_parts(by, at.position));
            ck_vector_same(other.weight, at.weight);
            ck_double_same(other.length, at.length);
            ck_assert(other.face.object == at.face.object && other.face.side == at.face.side);
        }
    }
    ck_assert_int_gt(landed, 50);
}

/* Law 2: a seed, a number and a cell have photons of their own. */
TEST(numbers_of_their_own)
{
    const sure_scene scene = falling_off(clear_in_white, clear_and_white, 2, &in_the_ball, 1);
    sure_vec3 at[4];
    for (int i = 0; i < 4; i++) {
        const sure_mixed_cell cell = {0, 1, 2, i == 1, 0, 2};
        sure_photon photon;
        ck_assert(sure_mixed_photon(&scene, SURE_TIER_CERTAIN, &cell, 2, i == 2, i == 3, &photon));
        at[i] = photon.position;
        for (int k = 0; k < i; k++)
            ck_assert(at[k].x != at[i].x && at[k].z != at[i].z);
    }
}

/* The lamp's own light is not the map's, and a way is no longer than the scene's depth. */
TEST(ways_that_bring_nothing)
{
    const sure_light lamp = {{1, 2, 0.25}, {1, 1, 1}, 20};
    static const struct {
        double mirror, floor; /* shares */
        int depth;
        bool brings;
    } rows[] = {{0, 1, 4, false}, {1, 1, 4, true}, {1, 1, 0, false}, {1, 0, 4, false}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double floor = rows[i].floor;
        const sure_material materials[] = {{.color = {1, 1, 1}, .mirror = rows[i].mirror},
                                           {.color = {floor, floor, floor}}};
        sure_scene scene = falling_off(mirror_and_floor, materials, 2, &lamp, 1);
        double sum = 0;
        scene.depth = rows[i].depth;
        trace_all(&scene, 4, 2, 0, add_weight, &sum);
        ck_assert_msg((sum > 0) == rows[i].brings, "row %zu", i);
    }
}

/* Both ways by which a photon goes on through a ball of glass cross two surfaces at least. */
TEST(as_long_as_the_depth)
{
    const sure_light lamp = {{0, 4, 0}, {1, 1, 1}, 20};
    const sure_object objects[] = {sphere(0, 2, 0, 1), sphere(0, 0, 0, 9)};
    const sure_material materials[] = {{.color = {1, 0.5, 0.25}, .refract = 1.5}, white};
    sure_scene scene = falling_off(objects, materials, 2, &lamp, 1);
    double sums[4] = {0};
    for (scene.depth = 0; scene.depth < 4; scene.depth++)
        trace_all(&scene, 16, 2, 0, add_weight, &sums[scene.depth]);
    ck_double_same(sums[0], 0);
    ck_assert(sums[1] > 0 && sums[2] > 2 * sums[1] && sums[3] > sums[2]);
}

/* 0 photons: as many as the picture asks for. */
static caustics_statistics photons_for(const sure_scene *scene, integrator_kind kind,
                                       uint64_t photons)
{
    FREED_BY(photon_map_free) sure_photon_map map = {0};
    return build(scene, kind, photons, 0, &map);
}

/* When photons are asked for, and why not: light that doesn't fall off only by those who insist,
 * and the mirror may face away from the floor's bright side. */
TEST(where_there_is_need)
{
    const sure_light lamps[] = {
        {{1, 2, 0.25}, {1, 1, 1}, 20}, {{1, 2, 0.25}, {1, 1, 1}, 0}, {{0, 9, 0}, {1, 1, 1}, 1}};
    const sure_object away[] = {disc((sure_vec3){0, 3, 0}, (sure_vec3){0, 1, 0}, 1),
                                mirror_and_floor[1]};
    const sure_material mirror = mirror_and_white[0];
    const sure_material glass = {.color = {1, 1, 1}, .refract = 1.5}, black = {.color = {0, 0, 0}};
    const struct {
        sure_material first, second;
        int lamp, depth;
        caustics_state state;
        bool endless, asked;
    } rows[] = {
        {mirror, white, 0, 4, CAUSTICS_ON, false, true},
        {glass, white, 0, 4, CAUSTICS_ON, false, true},
        {white, white, 0, 4, CAUSTICS_NOT_SHINY, false, true},
        {mirror, white, 0, 0, CAUSTICS_NOT_FOLLOWED, false, true},
        {mirror, white, 1, 4, CAUSTICS_NOT_LIT, false, true},
        {mirror, glass, 0, 4, CAUSTICS_NOT_MATTE, false, true},
        {mirror, black, 0, 4, CAUSTICS_NOT_MATTE, false, true},
        {mirror, white, 0, 4, CAUSTICS_ON, true, true},
        {mirror, white, 0, 4, CAUSTICS_ENDLESS, true, false},
        {mirror, white, 2, 4, CAUSTICS_NO_WAY, false, true},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const sure_material materials[] = {rows[i].first, rows[i].second};
        sure_scene scene = falling_off(rows[i].lamp == 2 ? away : mirror_and_floor, materials, 2,
                                       &lamps[rows[i].lamp], 1);
        scene.depth = rows[i].depth;
        scene.falloff = rows[i].endless ? SURE_FALLOFF_NONE : SURE_FALLOFF_INVERSE_SQUARE;
        caustics_statistics made =
            photons_for(&scene, rows[i].asked ? INTEGRATOR_MIXED : INTEGRATOR_AUTO, 3000);
        bool on = made.state == CAUSTICS_ON;
        ck_assert_msg(made.state == rows[i].state, "row %zu: state %d", i, (int)made.state);
        ck_assert((made.landed > 0) == on);
        ck_assert((made.traced > 0) == (on || made.state == CAUSTICS_NO_WAY));
    }
}

/* A lamp in a ceiling sends photons to the mirror as if there were none. */
TEST(a_lamp_in_a_surface)
{
    const sure_object room[] = {mirror_and_floor[0],
                                mirror_and_floor[1],
                                {SURE_SHAPE_PLANE, {.plane = {{9, 2, 9}, {0, -1, 0}}}}};
    const sure_material materials[] = {mirror_and_white[0], white, {.color = {0, 0, 0}}};
    const sure_light lamp = {{1, 2, 0.25}, {1, 1, 1}, 20};
    double sums[2] = {0, 0};
    for (int closed = 0; closed < 2; closed++) {
        sure_scene scene = falling_off(room, materials, closed ? 3 : 2, &lamp, 1);
        trace_all(&scene, 1, 16, 0, add_weight, &sums[closed]);
    }
    ck_assert(sums[0] > 0);
    ck_double_same(sums[1], sums[0]);
}

/* Each cell of each lamp has a photon, however few are asked for and whoever finds the cells. */
TEST(more_lamps_than_photons)
{
    enum { LAMPS = 300 };
    sure_light lamps[LAMPS];
    for (int i = 0; i < LAMPS; i++)
        lamps[i] = (sure_light){{1 + i / 100.0, 2, 0.25}, {1, 1, 1}, 20};
    const sure_scene scene = falling_off(mirror_and_floor, mirror_and_white, 2, lamps, LAMPS);
    caustics_statistics by[2];
    for (int i = 0; i < 2; i++) {
        FREED_BY(photon_map_free) sure_photon_map map = {0};
        const render_settings how = {.how = {.tier = SURE_TIER_CERTAIN, .threads = 1 + i},
                                     .integrator = INTEGRATOR_MIXED,
                                     .photons = 1};
        by[i] = caustics_build(&scene, &how, &map);
    }
    ck_assert_uint_ge(by[0].traced, 2 * LAMPS);
    ck_assert(by[0].traced == by[1].traced && by[0].landed == by[1].landed);
}

static caustics_statistics photons_of_size(sure_scene scene, int width, int height, uint64_t asked)
{
    scene.width = width;
    scene.height = height;
    return photons_for(&scene, INTEGRATOR_MIXED, asked);
}

/* Four or more numbers of pixels as in 80x45, times the square of `larger`: as many leave as where
 * 400 n^(5/4) are asked for by the share that lands of the first. */
static void check_as_many(const sure_scene *scene, const caustics_statistics *first, double larger)
{
    const double n = larger * larger, share = (double)first->landed / (double)first->traced;
    const double more = 400 * n * sqrt(sqrt(n)) / fmax(share, 0.25);
    const int width = (int)(80 * larger), height = (int)(45 * larger);
    const caustics_statistics of = photons_of_size(*scene, width, height, 0);
    const caustics_statistics expected = photons_of_size(*scene, width, height, (uint64_t)more);
    ck_assert_uint_eq(of.traced, expected.traced);
    ck_assert_uint_eq(of.landed, expected.landed);
}

/* The larger the picture and the fewer of the first land, the more leave; as many as are asked for
 * in any. Where none lands there are no others. Numbers are rounded to squares in each cell. */
TEST(as_many_as_the_picture_asks_for)
{
    const sure_light lamp = {{1, 2, 0.25}, {1, 1, 1}, 20}, behind = {{0, 9, 0}, {1, 1, 1}, 1};
    const sure_object away[] = {disc((sure_vec3){0, 3, 0}, (sure_vec3){0, 1, 0}, 1),
                                mirror_and_floor[1]};
    const sure_scene scene = falling_off(mirror_and_floor, mirror_and_white, 2, &lamp, 1);
    caustics_statistics small = photons_of_size(scene, 80, 45, 0);
    ck_assert_uint_eq(photons_of_size(scene, 16, 9, 0).traced, small.traced);
    ck_assert(small.traced > 200 && small.traced < 2000);
    uint64_t landed = small.landed;
    for (int n = 2; n <= 16; n *= 2) {
        caustics_statistics of = photons_of_size(scene, 80 * n, 45 * n, 0);
        double share = (double)of.landed / (400 * pow(n, 2.5));
        ck_assert_uint_gt(of.landed, 2 * landed);
        ck_assert_msg(share > 0.5 && share < 1.4, "%d: %g landed, of %g", n, share,
                      (double)of.traced);
        landed = of.landed;
    }
    check_as_many(&scene, &small, 1.25);
    check_as_many(&scene, &small, 2);
    double asked = (double)photons_of_size(scene, 16, 9, 100000).traced;
    ck_assert(asked > 66000 && asked < 150000);
    caustics_statistics none =
        photons_of_size(falling_off(away, mirror_and_white, 2, &behind, 1), 1280, 720, 0);
    ck_assert_int_eq(none.state, CAUSTICS_NO_WAY);
    ck_assert_uint_lt(none.traced, 2000);
}

LOOP_TEST(image_of_the_lamp, 2)
{
    const sure_light lamp = {{1, 2, 0.25}, {0.25, 0.5, 1}, 20},
                     image = {{-3, 2, 0.25}, {0.25, 0.5, 1}, 20};
    sure_scene scene = falling_off(mirror_and_floor, mirror_and_white, 2, &lamp, 1);
    scene.falloff = _i ? SURE_FALLOFF_NONE : SURE_FALLOFF_INVERSE_SQUARE;
    spot on = {.centre = {0.5, 0, 0.5}, .radius = 0.5, .falloff = scene.falloff};
    sample s = light_on(&scene, &on, 8, 5);
    expect_mean(&s, mean_light(&on, &image, all_of_it), 0.05, "light of the image");
}

LOOP_TEST(seen_by_the_eye, 2)
{
    const sure_light lamp = {{1, 2, 0}, {1, 1, 1}, 20}, image = {{-3, 2, 0}, {1, 1, 1}, 20};
    const double share = _i ? 0.25 : 1;
    const sure_object objects[] = {mirror_and_floor[0], plane(0, 0, -4, 0, 0, 1)};
    sure_material materials[] = {mirror_and_white[0], {.color = {1, 0.5, 1}, .mirror = 1 - share}};
    sure_scene scene = falling_off(objects, materials, 2, &lamp, 1);
    scene.camera.viewport_width = scene.camera.viewport_height = 0.1; /* within the mirror */
    scene.width = scene.height = 6;
    uint64_t nearest = 0;
    sample s;
    for (int i = 0; i < SEEDS; i++) {
        FREED_BY(photon_map_free) sure_photon_map map = map_of(&scene, _i ? 200000 : 20000, i);
        nearest = i == 0 || map.nearest < nearest ? map.nearest : nearest;
        s.value[i] = seen_of_image(&scene, &map, &image);
    }
    weigh(&s);
    ck_assert_uint_ge(nearest, 12);
    double truth = 0.5 * share;
    ck_assert_msg(fabs(s.mean - truth) <= s.doubt + truth / (double)nearest, "%g, not %g +- %g",
                  s.mean, truth, s.doubt);
    ck_assert(s.doubt <= truth / 4);
}

SUITE("mixed")

/* SPDX-License-Identifier: MIT */
/* What a picture may not depend on, without a golden one: a scene is drawn as it is and changed in
 * a way that changes nothing, or turns the picture round, and the bytes must be the same. For every
 * scene of tests/scenes and for scenes of random objects; tier `certain`. */
#include "../../src/scene/shapes/rt_shape.h"
#include "../support/scene_text.h"
#include "../support/sights.h"
#include "../support/small_scene.h"
#include "../support/suite.h"

/* Odd, so that the middle rays are exactly in the planes of symmetry. */
enum { WIDTH = 65, HEIGHT = 37, RANDOM_SCENES = 12, STREAM = 690 };

/* So few photons that their number would show. */
static const render_settings alone = {.how = {.tier = SURE_TIER_CERTAIN, .threads = 1},
                                      .integrator = INTEGRATOR_MIXED,
                                      .photons = 2000};

/* Where a law's premise does not hold. */
typedef enum { MIRROR_Z = 1, ORDER = 2, MOVE = 4, SCALE = 8, VARIETY = 16 } law;
static const struct {
    const char *scene;
    unsigned without;
    const char *because;
} premises[] = {
    {"wild", MIRROR_Z | MOVE, "a camera that looks straight down takes its roll from -z; needles"},
    {"down", MIRROR_Z, "the same"},
    {"coins", MOVE, "ends of bodies that are no higher than a few doubles are rounded elsewhere"},
    {"needles", MOVE, "the same"},
    {"ground_low", MOVE, "the same"},
    {"up", MIRROR_Z, "a camera that looks straight up does, too"},
    {"coincident", ORDER | MOVE, "its objects tie; no step is exact at its lamp and elsewhere"},
    {"ulp_apart", MOVE, "no step is exact at its lamp and elsewhere"},
    {"on_generator", ORDER, "in the middle column the cylinder's end ties with the plane there"},
    {"on_rim", ORDER, "the same"},
    {"on_wall", ORDER, "the wall's far side does"},
    {"on_sphere", ORDER, "the sphere's far side does"},
    {"on_plane_least", SCALE | VARIETY, "its least double has no half; the plane is all it shows"},
    {"on_sphere_without", VARIETY, "the sphere is all it shows, and one spot of it"},
};

static int scene_count(void)
{
    return RANDOM_SCENES + (int)scene_files(true)->gl_pathc;
}

/* A crowd is behind them all. */
static const char *path_of(int i)
{
    static char path[4096];
    if (i >= RANDOM_SCENES && i < scene_count())
        return scene_files(true)->gl_pathv[i - RANDOM_SCENES];
    snprintf(path, sizeof path, i < RANDOM_SCENES ? MADE "/random_%d.rt" : MADE "/M.rt", i);
    return path;
}

static bool holds(unsigned asked, int i)
{
    const char *name = strrchr(path_of(i), '/') + 1;
    for (size_t k = 0; k < sizeof premises / sizeof *premises; k++) {
        size_t length = strlen(premises[k].scene);
        if (strncmp(name, premises[k].scene, length) == 0 && name[length] == '.')
            return (premises[k].without & asked) == 0;
    }
    return true;
}

/* Small, whatever its size. */
static rt_scene scene_of(int i)
{
    return scene_of_size(path_of(i), WIDTH, HEIGHT);
}

static picture drawn(const rt_scene *file)
{
    return scene_drawn(file, &alone);
}

static picture shown(const rt_scene *file)
{
    FREED_BY(placement_free) sure_scene scene = scene_placed(file);
    return sights_picture(&scene, SURE_TIER_CERTAIN);
}

/* Each pixel the mean of n^2 rays. */
static picture drawn_finer(const rt_scene *file, int n)
{
    render_settings how = alone;
    how.how.samples = n;
    return scene_drawn(file, &how);
}

/* The pixel of `got` that belongs to a pixel of the plain picture. */
typedef struct {
    bool across, upright;
} flip;

static size_t place_of(int column, int row, flip turned)
{
    int x = turned.across ? WIDTH - 1 - column : column;
    int y = turned.upright ? HEIGHT - 1 - row : row;
    return 3 * ((size_t)y * WIDTH + (size_t)x);
}

static void expect_same(const picture *got, const picture *plain, flip turned, const char *what,
                        long detail)
{
    int wrong = 0, first = 0;
    for (int i = WIDTH * HEIGHT - 1; i >= 0; i--) {
        if (memcmp(got->rgb + place_of(i % WIDTH, i / WIDTH, turned), plain->rgb + 3 * i, 3) != 0) {
            wrong++;
            first = i;
        }
    }
    const uint8_t *a = got->rgb + place_of(first % WIDTH, first / WIDTH, turned);
    const uint8_t *b = plain->rgb + 3 * first;
    if (wrong > 0)
        ck_abort_msg("%s (%ld): %d pixels differ, first (%d, %d): %d,%d,%d, not %d,%d,%d", what,
                     detail, wrong, first % WIDTH, first / WIDTH, a[0], a[1], a[2], b[0], b[1],
                     b[2]);
}

static const flip as_it_is = {false, false};

/* So that no law holds because nothing is seen; and what mirrors and glass send to the others is
 * seen in all scenes of random objects. */
LOOP_TEST(something_is_seen, scene_count())
{
    render_settings how = alone;
    FREED_BY(rt_scene_free) rt_scene file = scene_of(_i);
    FREED_BY(picture_free) picture plain = drawn(&file);
    how.integrator = INTEGRATOR_BACKWARD;
    FREED_BY(picture_free) picture without = scene_drawn(&file, &how);
    int other = 0;
    for (int i = 1; i < WIDTH * HEIGHT; i++)
        other += memcmp(plain.rgb, plain.rgb + 3 * i, 3) != 0;
    ck_assert_msg(other > WIDTH || !holds(VARIETY, _i), "%s: only %d pixels differ from the first",
                  file.name, other);
    ck_assert_msg(_i >= RANDOM_SCENES || memcmp(plain.rgb, without.rgb, 3 * WIDTH * HEIGHT) != 0,
                  "%s: no pixel differs", file.name);
}

/* Of a coordinate of a position or direction. */
typedef void (*change)(double *coordinate, double by);

static void change_vector(sure_vec3 *v, change how, sure_vec3 by)
{
    how(&v->x, by.x);
    how(&v->y, by.y);
    how(&v->z, by.z);
}

static void change_elements(rt_scene *file, rt_kind which, change how, sure_vec3 by)
{
    for (size_t i = 0; i < file->element_count; i++) {
        const rt_element *element = &file->elements[i];
        for (const rt_field *f = rt_shapes[element->shape]->fields; f->name; f++) {
            if (f->kind == which)
                change_vector(rt_value(element, f), how, by);
        }
    }
}

static void change_positions(rt_scene *file, change how, sure_vec3 by)
{
    change_vector(&file->camera_position, how, by);
    for (size_t i = 0; i < file->light_count; i++)
        change_vector(&file->lights[i].light.position, how, by);
    change_elements(file, RT_POINT, how, by);
}

static void change_directions(rt_scene *file, change how, sure_vec3 by)
{
    change_vector(&file->camera_direction, how, by);
    change_elements(file, RT_DIRECTION, how, by);
}

/* Times 2^k, exactly. */
static void raise(double *x, double k)
{
    double scaled = ldexp(*x, (int)k);
    ck_assert(ldexp(scaled, -(int)k) == *x && (fabs(scaled) >= DBL_MIN || scaled == 0));
    *x = scaled;
}

static double largest(sure_vec3 v)
{
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/* The highest power of two in a coordinate. */
static int magnitude(const rt_scene *file)
{
    double most = largest(file->camera_position);
    for (size_t i = 0; i < file->element_count; i++)
        most = fmax(most, largest(file->elements[i].position));
    for (size_t i = 0; i < file->light_count; i++)
        most = fmax(most, largest(file->lights[i].light.position));
    return ilogb(most);
}

/* To the ends and to powers that every scene has its own of. */
static rt_scene scaled(int i, int variant, flip *turned)
{
    enum { END = 300 };
    rt_scene file = scene_of(i);
    int k = suite_integer(STREAM + 2, (uint64_t)(9 * i + variant), END);
    k = variant == 0 ? END : variant == 1 ? -END : k;
    k = abs(magnitude(&file)) > 200 ? k / 4 : k; /* it is scaled already */
    const sure_vec3 by = {k, k, k};
    change_positions(&file, raise, by);
    if (variant % 2)
        change_directions(&file, raise, by);
    for (size_t e = 0; e < file.element_count; e++) {
        raise(&file.elements[e].diameter, k);
        raise(&file.elements[e].height, k);
    }
    for (size_t l = 0; l < file.light_count; l++) {
        if (file.options.falloff == SURE_FALLOFF_INVERSE_SQUARE)
            raise(&file.lights[l].light.brightness, 2 * k);
    }
    *turned = as_it_is;
    return file;
}

/* To a multiple of it. */
static void round_to(double *x, double unit)
{
    *x = unit * nearbyint(*x / unit);
}

/* A step that is taken exactly. */
static void move(double *x, double step)
{
    double moved = *x + step;
    ck_assert(moved - *x == step && moved - step == *x);
    *x = moved;
}

/* The scene's coordinates as whole numbers of a unit, so that there are steps which all of them
 * take: none of tests/scenes is free of decimals that fill a double. */
static rt_scene on_a_grid(int i)
{
    rt_scene file = scene_of(i);
    const double unit = ldexp(1, magnitude(&file) - 40);
    change_positions(&file, round_to, (sure_vec3){unit, unit, unit});
    return file;
}

static rt_scene moved(int i, int variant, flip *turned)
{
    FREED_BY(rt_scene_free) rt_scene as_read = scene_of(i);
    rt_scene file = on_a_grid(i);
    const double unit = ldexp(1, magnitude(&as_read) - 40);
    double by[3];
    for (int axis = 0; axis < 3; axis++) {
        uint64_t bits = suite_bits(STREAM, (uint64_t)(100 * i + 3 * variant + axis));
        by[axis] = unit * (double)((int64_t)bits >> (13 + 8 * ((variant + axis) % 6)));
    }
    change_positions(&file, move, (sure_vec3){by[0], by[1], by[2]});
    *turned = as_it_is;
    return file;
}

static void multiply(double *x, double by)
{
    *x *= by;
}

static rt_scene mirrored_in(int i, int axis)
{
    rt_scene file = scene_of(i);
    change_positions(&file, multiply, mirror_of(axis));
    change_directions(&file, multiply, mirror_of(axis));
    return file;
}

/* In each axis, the camera along; of the other hand; both. */
static rt_scene mirrored(int i, int variant, flip *turned)
{
    static const flip flips[] = {{true, false}, {false, true}, {true, false}, {true, false}};
    bool as_told = variant != 2 || holds(MIRROR_Z, i);
    rt_scene file = variant == 3 ? scene_of(i) : mirrored_in(i, as_told ? variant % 4 : 0);
    if (variant >= 3)
        file.options.handedness =
            file.options.handedness == RT_LEFT_HANDED ? RT_RIGHT_HANDED : RT_LEFT_HANDED;
    *turned = variant < 4 ? flips[variant] : as_it_is;
    return file;
}

static void exchange(rt_scene *file, size_t a, size_t b)
{
    rt_element element = file->elements[a];
    sure_material material = file->materials[a];
    file->elements[a] = file->elements[b];
    file->materials[a] = file->materials[b];
    file->elements[b] = element;
    file->materials[b] = material;
}

/* The other way round, and shuffled. */
static rt_scene reordered(int i, int variant, flip *turned)
{
    rt_scene file = scene_of(i);
    for (size_t first = 0, last = file.element_count; first + 1 < last; first++)
        exchange(&file, first, --last);
    for (size_t count = file.element_count; variant > 0 && count > 1; count--)
        exchange(&file, count - 1, suite_bits(STREAM + 1 + (uint64_t)variant, count) % count);
    *turned = as_it_is;
    return file;
}

static const struct {
    const char *what;
    unsigned premise;
    int variants;
    rt_scene (*plain)(int i), (*other)(int i, int variant, flip *turned);
    picture (*seen)(const rt_scene *file);
} changes[] = {{"scaled by a power of two", SCALE, 9, scene_of, scaled, drawn},
               {"moved", MOVE, 6, on_a_grid, moved, shown}, /* its points are rounded elsewhere */
               {"mirrored", 0, 5, scene_of, mirrored, drawn},
               {"reordered", ORDER, 3, scene_of, reordered, drawn}};
enum { CHANGES = sizeof changes / sizeof *changes };

LOOP_TEST(changes_that_change_nothing, CHANGES *scene_count())
{
    const int of = _i % CHANGES, scene = _i / CHANGES;
    if (!holds(changes[of].premise, scene))
        return;
    FREED_BY(rt_scene_free) rt_scene file = changes[of].plain(scene);
    FREED_BY(picture_free) picture plain = changes[of].seen(&file);
    for (int variant = 0; variant < changes[of].variants; variant++) {
        flip turned;
        char label[256];
        FREED_BY(rt_scene_free) rt_scene other = changes[of].other(scene, variant, &turned);
        FREED_BY(picture_free) picture got = changes[of].seen(&other);
        snprintf(label, sizeof label, "%s: %s", file.name, changes[of].what);
        expect_same(&got, &plain, turned, label, variant);
    }
}

/* The mean too, whatever the side that its sum begins on. */
LOOP_TEST(mirrored_pictures_of_several_samples_are_flipped, scene_count() / 4)
{
    enum { EVERY = 4 };
    const int n = 2 + _i % 2, scene = EVERY * _i;
    FREED_BY(rt_scene_free) rt_scene file = scene_of(scene), other = mirrored_in(scene, 0);
    FREED_BY(picture_free) picture plain = drawn_finer(&file, n), got = drawn_finer(&other, n);
    expect_same(&got, &plain, (flip){true, false}, file.name, n);
}

static void copy_tile(const picture *tile, const picture_part *at, picture *whole)
{
    for (int row = 0; row < at->height; row++)
        memcpy(whole->rgb + place_of(at->x, at->y + row, as_it_is), tile->rgb + 3 * row * at->width,
               3 * (size_t)at->width);
}

/* Each tile by itself, the last first. */
static picture in_parts(const rt_scene *file, int width, int height, render_settings how)
{
    picture whole;
    ck_assert(picture_new(WIDTH, HEIGHT, &whole));
    for (int y = (HEIGHT - 1) / height * height; y >= 0; y -= height) {
        for (int x = (WIDTH - 1) / width * width; x >= 0; x -= width) {
            how.how.part = (picture_part){x, y, x + width < WIDTH ? width : WIDTH - x,
                                          y + height < HEIGHT ? height : HEIGHT - y};
            FREED_BY(picture_free) picture tile = scene_drawn(file, &how);
            copy_tile(&tile, &how.how.part, &whole);
        }
    }
    return whole;
}

/* In tiles and by more threads by `certain`, whole by `exact`. */
LOOP_TEST(in_tiles_with_and_without_boxes, scene_count() + 1)
{
    static const int ways[][3] = {{WIDTH, HEIGHT, 1}, {WIDTH, 7, 1},      {17, HEIGHT, 1},
                                  {13, 11, 1},        {WIDTH, HEIGHT, 2}, {WIDTH, HEIGHT, 3},
                                  {WIDTH, HEIGHT, 4}, {WIDTH, HEIGHT, 5}};
    FREED_BY(rt_scene_free) rt_scene file = scene_of(_i);
    for (sure_tier tier = SURE_TIER_CERTAIN; tier <= SURE_TIER_EXACT; tier++) {
        render_settings how = alone;
        how.how.tier = tier;
        FREED_BY(picture_free) picture plain = scene_drawn(&file, &how);
        for (int i = 0; i < (tier == SURE_TIER_CERTAIN ? 12 : 2); i++) {
            const int *way = ways[i < 8 ? i / 2 : i - 4];
            how.how.threads = way[2];
            how.how.without_bvh = i < 8 && i % 2;
            FREED_BY(picture_free) picture got = in_parts(&file, way[0], way[1], how);
            expect_same(&got, &plain, as_it_is, file.name, i);
        }
    }
}

SUITE("metamorphic")

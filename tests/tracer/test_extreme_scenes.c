/* The extreme scenes: what certain and exact show in every pixel is the truth, told by the exact
 * reference, by whole numbers and by what is known of a scene beforehand. */
#include "../support/line_signs.h"
#include "../support/objects.h"
#include "../support/scene_text.h"
#include "../support/sights.h"
#include "../support/suite.h"

#include "placement.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Odd, so that the middle rays are exactly in the planes of symmetry. */
enum { WIDTH = 81, HEIGHT = 45, PIXELS = WIDTH * HEIGHT };

static const sure_tier tiers[] = {SURE_TIER_CERTAIN, SURE_TIER_EXACT};

static int scene_count(void)
{
    return (int)scene_files(false)->gl_pathc;
}

static const char *path_of(int i)
{
    return scene_files(false)->gl_pathv[i];
}

static rt_scene small(const char *path)
{
    return scene_of_size(path, WIDTH, HEIGHT);
}

static sure_scene placed(const char *path)
{
    rt_scene file = small(path);
    sure_scene scene = scene_placed(&file);
    rt_scene_free(&file);
    return scene;
}

static const char *extreme(const char *name)
{
    return suite_file("scenes/extreme/%s.rt", name);
}

static sights drawn(const sure_scene *scene, sure_tier tier)
{
    sights seen;
    ck_assert(sights_drawn(scene, tier, &seen));
    return seen;
}

LOOP_TEST(no_pixel_shows_a_wrong_object, scene_count())
{
    sure_scene scene = placed(path_of(_i));
    sights truth;
    ck_assert(sights_true(&scene, &truth));
    for (size_t k = 0; k < sizeof tiers / sizeof *tiers; k++) {
        sights seen = drawn(&scene, tiers[k]);
        ck_assert_msg(sights_differ(&seen, &truth) == 0, "%s, tier %s: %d pixels are wrong",
                      path_of(_i), sure_tier_name(tiers[k]), sights_differ(&seen, &truth));
        sights_free(&seen);
    }
    sights_free(&truth);
    placement_free(&scene);
}

/* No acne: a lamp in the eye shines on all that is seen. Not so where the eye touches a surface and
 * looks along it. */
LOOP_TEST(no_pixel_is_in_a_false_shadow, scene_count())
{
    if (strstr(path_of(_i), "/on_"))
        return;
    sure_scene scene = placed(path_of(_i));
    for (size_t k = 0; k < sizeof tiers / sizeof *tiers; k++) {
        bool ok;
        int dark = sights_dark(&scene, tiers[k], &ok);
        ck_assert(ok);
        ck_assert_msg(dark == 0, "%s, tier %s: %d pixels are dark", path_of(_i),
                      sure_tier_name(tiers[k]), dark);
    }
    placement_free(&scene);
}

/* And by the tracer's own statistics, of the scene's lights and mirrors. No surface is so near in
 * front of another that a ray could start behind it. */
LOOP_TEST(no_ray_meets_the_surface_that_it_leaves, scene_count())
{
    rt_scene file = small(path_of(_i));
    for (size_t k = 0; k < sizeof tiers / sizeof *tiers; k++) {
        sure_statistics statistics = {0};
        picture image = scene_drawn(
            &file, &(render_settings){.how = {tiers[k], .threads = 1, .statistics = &statistics}});
        ck_assert_uint_eq(statistics.rays[SURE_RAY_PIXEL], PIXELS);
        ck_assert_uint_eq(statistics.acne, 0);
        ck_assert_uint_eq(statistics.covered, 0);
        picture_free(&image);
    }
    rt_scene_free(&file);
}

/* From outside, the sphere ahead: does the ray's line meet it? By the file's numbers, unrounded.
 * The camera looks along -z: nothing is turned. */
static bool covers(const rt_scene *file, sure_vec3 direction)
{
    const rt_element *ball = file->elements;
    const sure_vec3 eye = file->camera_position, at = ball->position;
    const sure_case line = {{eye, direction, 0, INFINITY},
                            sphere(at.x, at.y, at.z, ball->diameter / 2)};
    ck_assert_int_eq(point_signs_at(&line, 0, 0).round, 1);
    return line_signs_of(&line).discriminant >= 0 && dot(minus(at, eye), direction) > 0;
}

static const char *const spheres[] = {"sphere_1e5", "sphere_1e7", "sphere_1e12", "fill_1e5",
                                      "fill_1e6",   "fill_1e7",   "fill_1e8"};

LOOP_TEST(a_far_sphere_has_its_exact_silhouette, (int)(sizeof spheres / sizeof *spheres))
{
    rt_scene file = small(extreme(spheres[_i]));
    sure_scene scene = scene_placed(&file);
    sights seen = drawn(&scene, SURE_TIER_CERTAIN);
    int covered = 0;
    for (int i = 0; i < PIXELS; i++) {
        sure_ray ray = sure_scene_pixel_ray(&scene, i % WIDTH, HEIGHT - 1 - i / WIDTH);
        bool met = covers(&file, ray.direction);
        covered += met;
        ck_assert_msg(met == (seen.objects[i] == 0), "%s: pixel (%d, %d) is wrong", spheres[_i],
                      i % WIDTH, i / WIDTH);
    }
    ck_assert(strncmp(spheres[_i], "fill", 4) == 0 ? covered == PIXELS
                                                   : covered > PIXELS / 9 && covered < PIXELS / 2);
    sights_free(&seen);
    placement_free(&scene);
    rt_scene_free(&file);
}

/* Pairs of surfaces at one place, or a double apart. */
static const struct {
    const char *name;
    int hidden; /* which of each pair */
} pairs[] = {{"coincident", 1}, {"ulp_apart", 0}};

LOOP_TEST(of_twins_the_right_one_is_seen, 2)
{
    sure_scene scene = placed(extreme(pairs[_i].name));
    sights seen = drawn(&scene, SURE_TIER_CERTAIN);
    int pixels[10] = {0};
    ck_assert_uint_eq(scene.object_count, 10);
    for (int i = 0; i < PIXELS; i++) {
        ck_assert_int_ne(seen.objects[i], SIGHT_NOTHING);
        pixels[seen.objects[i]]++;
    }
    for (int i = 0; i < 10; i++)
        ck_assert_msg((pixels[i] > 0) == (i % 2 != pairs[_i].hidden), "%s: object %d in %d pixels",
                      pairs[_i].name, i, pixels[i]);
    sights_free(&seen);
    placement_free(&scene);
}

/* A cylinder stands on a floor that comes first in the file: from below, where its cap and the
 * floor are one plane, the floor is seen; from above what the reference tells. */
enum { CAMERAS = 1000, ABOVE_EVERY = 50 };

static sure_scene standing(uint64_t i, bool below, int width, int height)
{
    char text[512];
    sure_vec3 at = suite_doubles(30, i, 2), by = suite_doubles(31, i, 2);
    double up = fabs(at.y) + (below ? 0 : 2);
    snprintf(text, sizeof text,
             "A 1 255,255,255\nC %.17g,%.17g,%.17g %.17g,%.17g,%.17g 60\nL 0,-50,0 0.5\n"
             "pl 0,0,0 0,1,0 255,255,255\ncy 0,1,0 0,1,0 8 2 255,0,0\n",
             at.x, below ? -up : up, at.z, by.x / 4 - at.x, (below ? up : -up) + by.y / 4,
             by.z / 4 - at.z);
    rt_scene file = scene_from_text(text, "standing");
    file.options.width = width;
    file.options.height = height;
    sure_scene scene = scene_placed(&file);
    rt_scene_free(&file);
    return scene;
}

static int pixels_of_object(const sights *seen, int object)
{
    int count = 0;
    for (int i = 0; i < seen->width * seen->height; i++)
        count += seen->objects[i] == object;
    return count;
}

TEST(a_cylinder_stands_on_a_floor)
{
    int floors = 0, walls = 0;
    for (uint64_t i = 0; i < CAMERAS; i++) {
        sure_scene scene = standing(i, true, 48, 27);
        sights seen = drawn(&scene, SURE_TIER_CERTAIN);
        floors += pixels_of_object(&seen, 0);
        ck_assert_msg(pixels_of_object(&seen, 1) == 0, "camera %lu: the cap is seen in %d pixels",
                      (unsigned long)i, pixels_of_object(&seen, 1));
        sights_free(&seen);
        placement_free(&scene);
    }
    for (uint64_t i = 0; i < CAMERAS; i += ABOVE_EVERY) {
        sure_scene scene = standing(i, false, 33, 19);
        sights seen = drawn(&scene, SURE_TIER_CERTAIN), truth;
        ck_assert(sights_true(&scene, &truth));
        ck_assert_int_eq(sights_differ(&seen, &truth), 0);
        walls += pixels_of_object(&seen, 1);
        sights_free(&truth);
        sights_free(&seen);
        placement_free(&scene);
    }
    ck_assert_int_gt(floors, CAMERAS * 48 * 27 / 2);
    ck_assert_int_gt(walls, CAMERAS / ABOVE_EVERY * 33 * 19 / 4);
}

enum { COLORS_MOST = 3 };

/* How many an object is seen in, COLORS_MOST at most. */
static int colors_of(int object, const sights *seen, const picture *image)
{
    int colors[COLORS_MOST], count = 0;
    for (int i = 0; i < PIXELS && count < COLORS_MOST; i++) {
        const uint8_t *rgb = image->rgb + 3 * i;
        int color = rgb[0] << 16 | rgb[1] << 8 | rgb[2], known = 0;
        if (seen->objects[i] != object)
            continue;
        while (known < count && colors[known] != color)
            known++;
        if (known == count)
            colors[count++] = color;
    }
    return count;
}

/* The lamp is so far that the ways to it are parallel: a plane has one colour in the light and one
 * in the shadow. No shadow falls on the wall. */
LOOP_TEST(twins_have_no_stripes, 2)
{
    const render_settings how = {.how = {.tier = SURE_TIER_CERTAIN, .threads = 1}};
    const int seen_one = 1 - pairs[_i].hidden;
    rt_scene file = small(extreme(pairs[_i].name));
    sure_scene scene = scene_placed(&file);
    picture image = scene_drawn(&file, &how);
    sights seen = drawn(&scene, SURE_TIER_CERTAIN);
    ck_assert_int_eq(colors_of(seen_one, &seen, &image), 2);
    ck_assert_int_eq(colors_of(8 + seen_one, &seen, &image), 1);
    sights_free(&seen);
    picture_free(&image);
    placement_free(&scene);
    rt_scene_free(&file);
}

SUITE("extreme scenes")

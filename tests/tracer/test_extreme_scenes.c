/* SPDX-License-Identifier: MIT */
/* The extreme scenes: what certain and exact show in every pixel is the truth, told by the exact
 * reference, by whole numbers and by what is known of a scene beforehand. */
#include "../support/line_signs.h"
#include "../support/objects.h"
#include "../support/scene_text.h"
#include "../support/sights.h"
#include "../support/suite.h"

/* Odd, so that the middle rays are exactly in the planes of symmetry. */
enum { WIDTH = 81, HEIGHT = 45, PIXELS = WIDTH * HEIGHT };

static rt_scene small(const char *path)
{
    return scene_of_size(path, WIDTH, HEIGHT);
}

static const char *extreme(const char *name)
{
    return suite_file("scenes/extreme/%s.rt", name);
}

/* No acne: a lamp in the eye shines on all that is seen. Not so where the eye touches a surface and
 * looks along it. And by the tracer's own statistics, of the scene's lights and mirrors, no ray
 * meets the surface that it leaves, and none is so near in front of another that a ray could start
 * behind it. */
LOOP_TEST(no_pixel_is_wrong, (int)scene_files(false)->gl_pathc)
{
    const char *path = scene_files(false)->gl_pathv[_i];
    FREED_BY(rt_scene_free) rt_scene file = small(path);
    FREED_BY(placement_free) sure_scene scene = scene_placed(&file);
    FREED_BY(sights_free) sights truth = sights_true(&scene);
    for (sure_tier tier = SURE_TIER_CERTAIN; tier <= SURE_TIER_EXACT; tier++) {
        sure_statistics statistics = {0};
        FREED_BY(sights_free) sights seen = sights_drawn(&scene, tier);
        int wrong = sights_differ(&seen, &truth), dark = sights_dark(&scene, tier);
        ck_assert_msg(wrong == 0, "%s, tier %s: %d pixels show another object", path,
                      sure_tier_name(tier), wrong);
        ck_assert_msg(dark == 0 || strstr(path, "/on_"), "%s, tier %s: %d pixels are dark", path,
                      sure_tier_name(tier), dark);
        const render_settings how = {.how = {tier, .threads = 1, .statistics = &statistics}};
        FREED_BY(picture_free) picture image = scene_drawn(&file, &how);
        ck_assert_uint_eq(statistics.rays[SURE_RAY_PIXEL], PIXELS);
        ck_assert_uint_eq(statistics.acne + statistics.covered, 0);
    }
}

/* From outside, the sphere ahead: does the ray's line meet it? By the file's numbers, unrounded.
 * The camera looks along -z: nothing is turned. */
static bool covers(const rt_scene *file, sure_vec3 direction)
{
    const rt_element *ball = file->elements;
    const sure_vec3 eye = file->camera_position, at = ball->position;
    const sure_case line = {.ray = {eye, direction, 0, INFINITY},
                            .object = sphere(at.x, at.y, at.z, ball->diameter / 2)};
    ck_assert_int_eq(point_signs_at(&line, 0, 0).round, 1);
    return line_signs_of(&line).discriminant >= 0 && dot(minus(at, eye), direction) > 0;
}

static const char *const spheres[] = {"sphere_1e5", "sphere_1e7", "sphere_1e12", "fill_1e5",
                                      "fill_1e6",   "fill_1e7",   "fill_1e8"};

LOOP_TEST(a_far_sphere_has_its_exact_silhouette, (int)(sizeof spheres / sizeof *spheres))
{
    FREED_BY(rt_scene_free) rt_scene file = small(extreme(spheres[_i]));
    FREED_BY(placement_free) sure_scene scene = scene_placed(&file);
    FREED_BY(sights_free) sights seen = sights_drawn(&scene, SURE_TIER_CERTAIN);
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
}

static int pixels_of_object(const sights *seen, int object)
{
    int count = 0;
    for (int i = 0; i < seen->width * seen->height; i++)
        count += seen->objects[i] == object;
    return count;
}

/* How many an object is seen in, 3 at most. */
static int colors_of(int object, const sights *seen, const picture *image)
{
    int colors[3], count = 0;
    for (int i = 0; i < PIXELS && count < 3; i++) {
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

/* Pairs of surfaces at one place, or a double apart. */
static const struct {
    const char *name;
    int hidden; /* which of each pair */
} pairs[] = {{"coincident", 1}, {"ulp_apart", 0}};

/* The lamp is so far that the ways to it are parallel: a plane has one colour in the light and one
 * in the shadow. No shadow falls on the wall. */
LOOP_TEST(of_twins_the_right_one_is_seen_without_stripes, 2)
{
    const render_settings how = {.how = {.tier = SURE_TIER_CERTAIN, .threads = 1}};
    const int seen_one = 1 - pairs[_i].hidden;
    FREED_BY(rt_scene_free) rt_scene file = small(extreme(pairs[_i].name));
    FREED_BY(placement_free) sure_scene scene = scene_placed(&file);
    FREED_BY(picture_free) picture image = scene_drawn(&file, &how);
    FREED_BY(sights_free) sights seen = sights_drawn(&scene, SURE_TIER_CERTAIN);
    ck_assert_uint_eq(scene.object_count, 10);
    ck_assert_int_eq(pixels_of_object(&seen, SIGHT_NOTHING), 0);
    for (int i = 0; i < 10; i++)
        ck_assert_msg((pixels_of_object(&seen, i) > 0) == (i % 2 == seen_one), "%s: object %d",
                      pairs[_i].name, i);
    ck_assert_int_eq(colors_of(seen_one, &seen, &image), 2);
    ck_assert_int_eq(colors_of(8 + seen_one, &seen, &image), 1);
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
    FREED_BY(rt_scene_free) rt_scene file = scene_from_text(text, "standing");
    file.options.width = width;
    file.options.height = height;
    return scene_placed(&file);
}

TEST(a_cylinder_stands_on_a_floor)
{
    int floors = 0, walls = 0;
    for (uint64_t i = 0; i < CAMERAS; i++) {
        FREED_BY(placement_free) sure_scene scene = standing(i, true, 48, 27);
        FREED_BY(sights_free) sights seen = sights_drawn(&scene, SURE_TIER_CERTAIN);
        floors += pixels_of_object(&seen, 0);
        ck_assert_msg(pixels_of_object(&seen, 1) == 0, "camera %d sees the cap", (int)i);
    }
    for (uint64_t i = 0; i < CAMERAS; i += ABOVE_EVERY) {
        FREED_BY(placement_free) sure_scene scene = standing(i, false, 33, 19);
        FREED_BY(sights_free)
        sights seen = sights_drawn(&scene, SURE_TIER_CERTAIN), truth = sights_true(&scene);
        ck_assert_int_eq(sights_differ(&seen, &truth), 0);
        walls += pixels_of_object(&seen, 1);
    }
    ck_assert_int_gt(floors, CAMERAS * 48 * 27 / 2);
    ck_assert_int_gt(walls, CAMERAS / ABOVE_EVERY * 33 * 19 / 4);
}

SUITE("extreme scenes")

/* SPDX-License-Identifier: MIT */
/* How far from the truth are the mixed and the forward tracer after the same time?
 *
 *     forward_error SCENE PHOTONS [SAMPLES]   the truth is a run of so many photons; the mixed
 *                                             picture has SAMPLES x SAMPLES rays a pixel (2)
 *
 * Compared is what both can see: pixels where every ray of SAMPLES x SAMPLES meets a matte surface
 * or none, since to a pinhole no photon comes by a mirror. Values are those of a picture, from 0 to
 * 1, of light that has met one matte surface (bounces 1). The truth is two
 * runs of half the photons each, a and b, and an error the mean of (value - a)(value - b), in which
 * their own variance has no part. One line of JSON. */
#include "caustics.h"
#include "bvh_build.h"
#include "openmp.h"
#include "progress.h"
#include "render_file.h"
#include "forward_sum.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <surehit/backward.h>

/* Photons of the forward run begin here: none of them is the truth's. */
#define OTHERS (UINT64_C(1) << 40)
/* And so many tell how long one takes, beside which a start of threads takes none. */
#define TRIAL 5000000

typedef struct {
    sure_vec3 *values;
    bool *compared;
    double seconds;
} mixed_picture;

static _Noreturn void fail(const char *what)
{
    fprintf(stderr, "forward_error: error: %s\n", what);
    exit(1);
}

static void *room_for(size_t count, size_t size)
{
    void *room = calloc(count, size);
    if (!room)
        fail("no memory");
    return room;
}

/* Is what the ray has met matte, or nothing? */
static bool is_seen_by_photons(const sure_scene *scene, const sure_statistics *told)
{
    const sure_material *material = &scene->materials[told->nearest.object];
    return told->seen != SURE_HIT || (!(material->mirror > 0) && !(material->refract > 0));
}

/* And whether all its rays meet what photons see. */
static sure_vec3 mean_of(const sure_scene *fine, int column, int row, int samples, bool *compared)
{
    sure_vec3 sum = {0, 0, 0};
    *compared = true;
    for (int i = 0; i < samples * samples; i++) {
        sure_statistics told = {0};
        sure_vec3 seen =
            sure_backward_pixel_told(fine, SURE_TIER_CERTAIN, column * samples + i % samples,
                                     row * samples + i / samples, &told);
        *compared = *compared && is_seen_by_photons(fine, &told);
        sum = (sure_vec3){sum.x + seen.x, sum.y + seen.y, sum.z + seen.z};
    }
    double rays = (double)samples * samples;
    return (sure_vec3){sum.x / rays, sum.y / rays, sum.z / rays};
}

/* Rows from the top, as a film's. */
static mixed_picture draw_mixed(const sure_scene *scene, int samples)
{
    const int count = scene->width * scene->height;
    mixed_picture made = {room_for((size_t)count, sizeof(sure_vec3)),
                          room_for((size_t)count, sizeof(bool)), 0};
    const render_settings settings = RENDER_DEFAULTS;
    sure_photon_map map;
    sure_scene fine = *scene;
    double started = progress_clock();
    caustics_statistics passed = caustics_build(scene, &settings, &map);
    fine.caustics = passed.state == CAUSTICS_ON ? &map : NULL;
    fine.width *= samples;
    fine.height *= samples;
    OPENMP(omp parallel for schedule(dynamic, 256))
    for (int i = 0; i < count; i++)
        made.values[i] = mean_of(&fine, i % scene->width, scene->height - 1 - i / scene->width,
                                 samples, &made.compared[i]);
    made.seconds = progress_clock() - started;
    if (fine.caustics)
        photon_map_free(&map);
    return made;
}

static double number_of(film_sum sum)
{
    return (double)sum * 0x1p-32;
}

/* Seconds that it took. */
static double trace(const sure_scene *scene, uint64_t first, uint64_t photons, film *sums)
{
    forward_sum done = {.sum = {.tier = SURE_TIER_CERTAIN, .how = {.bounces = 1}}};
    const index_range asked = {first, first + photons};
    double started = progress_clock();
    if (!film_new(scene->width, scene->height, &done.sum.sums) ||
        !forward_sum_trace(scene, &(render_options){0}, asked, &done))
        fail("no memory");
    *sums = done.sum.sums;
    free(done.sum.ranges.of);
    return progress_clock() - started;
}

typedef struct {
    const mixed_picture *mixed;
    film truth[2];
    double photons; /* of each truth */
} comparison;

static double shown(double value)
{
    return value < 1 ? value : 1;
}

static double off(double value, const film *truth, int pixel, int color, double photons)
{
    return shown(value) - shown(number_of(truth->pixels[pixel].value[color]) / photons);
}

/* The mean over compared pixels and colours; `other` is a film of so many photons, or NULL: the
 * mixed picture. */
static double error_of(const comparison *with, const film *other, double photons)
{
    const film *truth = with->truth;
    double sum = 0, count = 0;
    for (int i = 0; i < truth->width * truth->height; i++) {
        const double mixed[3] = {with->mixed->values[i].x, with->mixed->values[i].y,
                                 with->mixed->values[i].z};
        for (int c = 0; c < 3 && with->mixed->compared[i]; c++) {
            double value = other ? number_of(other->pixels[i].value[c]) / photons : mixed[c];
            sum += off(value, &truth[0], i, c, with->photons) *
                   off(value, &truth[1], i, c, with->photons);
            count++;
        }
    }
    return sum / count;
}

static void compare(const char *path, const sure_scene *scene, uint64_t photons, int samples)
{
    const uint64_t half = photons / 2;
    film trial, forward;
    mixed_picture mixed = draw_mixed(scene, samples);
    double a_photon = trace(scene, 2 * OTHERS, TRIAL, &trial) / TRIAL;
    uint64_t as_many = (uint64_t)(mixed.seconds / a_photon);
    double seconds = trace(scene, OTHERS, as_many, &forward);
    comparison with = {.mixed = &mixed, .photons = (double)half};
    double truth_seconds = trace(scene, 0, half, &with.truth[0]);
    truth_seconds += trace(scene, half, half, &with.truth[1]);
    double of_mixed = error_of(&with, NULL, 0);
    double of_forward = error_of(&with, &forward, (double)as_many);
    printf("{\"scene\": \"%s\", \"samples\": %d, \"truth_photons\": %.0f, \"truth_seconds\": %.2f, "
           "\"mixed_seconds\": %.3f, \"forward_seconds\": %.3f, \"forward_photons\": %.0f, "
           "\"mixed_error\": %.6g, \"forward_error\": %.6g}\n",
           path, samples, 2 * with.photons, truth_seconds, mixed.seconds, seconds, (double)as_many,
           of_mixed, of_forward);
    film_free(&with.truth[0]);
    film_free(&with.truth[1]);
    film_free(&trial);
    film_free(&forward);
    free(mixed.values);
    free(mixed.compared);
}

int main(int count, char **words)
{
    render_settings settings = RENDER_DEFAULTS;
    placed_scene placed;
    sure_bvh bvh;
    if (count < 3 || count > 4)
        fail("usage: forward_error SCENE PHOTONS [SAMPLES]");
    if (!render_file_place(words[1], &settings, stderr, &placed))
        return 2;
    sure_scene *scene = &placed.scene;
    const sure_bvh *built = bvh_for(scene, true, 0, &bvh);
    scene->bvh = built ? &bvh : NULL;
    compare(words[1], scene, strtoull(words[2], NULL, 10), count > 3 ? atoi(words[3]) : 2);
    if (built)
        bvh_free(&bvh);
    placement_free(&placed.scene);
    return 0;
}

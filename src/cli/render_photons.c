/* `surehit render --integrator forward`. */
#include "render.h"

#include "../evidence/certificate.h"
#include "../evidence/explain.h"
#include "../photons/forward_sum.h"
#include "../support/json_file.h"
#include "../support/progress.h"

#include <inttypes.h>
#include <stdio.h>

#define BOUNCES_DEFAULT 16

/* Light that does not fall off has no energy to be spread by further bounces. */
static int resolve_bounces(const placed_scene *placed, int *bounces)
{
    bool falls = placed->options.falloff == SURE_FALLOFF_INVERSE_SQUARE;
    *bounces = asked.bounces;
    if (*bounces == 0)
        *bounces = falls ? BOUNCES_DEFAULT : 1;
    if (falls || *bounces == 1)
        return 0;
    return cli_wrong(
        "--bounces %d does not go with --falloff none: light goes on only where it falls "
        "off: add --falloff inverse-square",
        *bounces);
}

/* The share first: it can be drawn again, the picture cannot be added to. */
static int write_all(const partial_film *sum)
{
    picture image;
    bool written = !asked.share || partial_film_write(sum, asked.share, stderr);
    if (!film_picture_new(&sum->sums, sum->statistics.emitted, &image)) {
        fprintf(stderr, "%s: error: no memory for this picture\n", asked.scene);
        return EXIT_OUTPUT;
    }
    int status = render_write_pictures(&image);
    picture_free(&image);
    return written ? status : EXIT_OUTPUT;
}

static void print_times(const placed_scene *placed, const forward_sum *done, double write)
{
    json_t *object = render_times_json(placed, done->times.build, NULL, done->times.frame, write);
    json_object_update_new(object, photons_json(&done->sum, forward_sum_seconds(done)));
    json_print_line(object, stdout);
}

static void print_interrupted(const partial_film *sum)
{
    fprintf(stderr, "%s: interrupted after %" PRIu64 " photons (", command_render.name,
            sum->statistics.emitted);
    photons_print_ranges(stderr, sum);
    if (asked.share)
        fprintf(stderr, "); go on with the same words and --continue %s\n", asked.share);
    else
        fputs("); to be able to go on, give --share FILE\n", stderr);
}

static int finish(const placed_scene *placed, const forward_sum *done, double started)
{
    double traced = progress_clock();
    int status = write_all(&done->sum);
    double now = progress_clock();
    if (status != 0)
        return status;
    if (!asked.quiet) {
        render_print_summary(asked.share, done->sum.sums.width, done->sum.sums.height,
                             now - started + placed->read + placed->place);
        photons_print(stdout, &done->sum, forward_sum_seconds(done));
    }
    if (asked.explain)
        explain_features(stdout, &placed->scene, &asked.settings.how);
    if (asked.time)
        print_times(placed, done, now - traced);
    if (done->interrupted)
        print_interrupted(&done->sum);
    return done->interrupted ? EXIT_INTERRUPTED : 0;
}

int render_photons(const placed_scene *placed)
{
    forward_plan plan = {
        .scene = asked.scene,
        .placed = placed,
        .settings = &asked.settings,
        .how = {.seed = asked.settings.seed, .aperture = asked.aperture},
        .first = asked.first,
        .from = asked.from,
    };
    double started = progress_clock();
    forward_sum done;
    int status = resolve_bounces(placed, &plan.how.bounces);
    if (status != 0)
        return status;
    if ((asked.share || asked.from) && !certificate_hash(asked.scene, stderr, &plan.hash))
        return EXIT_USAGE;
    status = forward_sum_of(&plan, stderr, &done) ? finish(placed, &done, started) : EXIT_USAGE;
    partial_film_free(&done.sum);
    return status;
}

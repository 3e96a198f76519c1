/* SPDX-License-Identifier: MIT */
/* The two ways to draw what `surehit render` is asked for. */
#include "pieces/photons.h"
#include "pieces/squares.h"
#include "render.h"

#include "../evidence/blackness.h"
#include "../evidence/certificate.h"
#include "../evidence/explain.h"
#include "../photons/map/caustics.h"
#include "../scene/rt_notes.h"
#include "../support/complain.h"
#include "../support/json_file.h"
#include "../support/pieces/cut.h"
#include "../support/progress.h"

#include <inttypes.h>
#include <stdlib.h>

/* All of them, or EXIT_OUTPUT. */
static int write_pictures(const picture *image)
{
    for (int i = 0; i < asked.outputs.count; i++) {
        if (!picture_write(image, asked.outputs.texts[i], stderr))
            return EXIT_OUTPUT;
    }
    return 0;
}

/* "a.ppm, a.png, other: 320x180, 1.23 s"; `other` may be NULL. */
static void print_summary(const char *other, int width, int height, double seconds)
{
    for (int i = 0; i < asked.outputs.count; i++)
        printable_printf(asked.words, "%s%s", i > 0 ? ", " : "", asked.outputs.texts[i]);
    if (other)
        printable_printf(asked.words, ", %s", other);
    fprintf(asked.words, ": %dx%d, %.2f s\n", width, height, seconds);
}

/* Seconds and bytes, for programs; `forward`, of the forward pass, may be NULL. */
static json_t *times_json(const placed_scene *placed, const scene_times *times, json_t *forward,
                          double write)
{
    size_t bytes = scene_bytes(&placed->scene, asked.settings.how.tier);
    return json_pack(
        "{s:f, s:f, s:f, s:o*, s:f, s:f, s:I, s:i, s:I, s:I, s:I}", "read", placed->read, "place",
        placed->place, "build", times->build, "forward", forward, "frame", times->frame, "write",
        write, "objects", (json_int_t)placed->scene.object_count, "threads",
        render_threads(&asked.settings.how), "object_bytes", (json_int_t)bytes, "hierarchy_bytes",
        (json_int_t)times->bytes, "photon_bytes", (json_int_t)times->caustics.bytes);
}

/* From the eye. */

/* What is drawn and what is known of it. */
typedef struct {
    const placed_scene *placed;
    rendering drawn;
    picture heat; /* rgb NULL where light was asked for */
    double write; /* seconds */
} outcome;

static int write_certificate(const outcome *of)
{
    certificate said = {
        .hash = of->placed->hash,
        .options = of->placed->options,
        .part = asked.settings.how.part,
        .tier = asked.settings.how.tier,
        .statistics = of->drawn.statistics,
    };
    said.part.width = of->drawn.image.width;
    said.part.height = of->drawn.image.height;
    bool written = certificate_write(&said, asked.scene, &of->placed->scene, of->drawn.records,
                                     asked.certificate);
    return written ? 0 : EXIT_OUTPUT;
}

static const picture *shown(const outcome *of)
{
    return of->heat.rgb ? &of->heat : &of->drawn.image;
}

static int write_all(outcome *of)
{
    double started = progress_clock();
    int status = write_pictures(shown(of));
    if (status == 0 && asked.certificate)
        status = write_certificate(of);
    of->write = progress_clock() - started;
    return status;
}

/* Seconds are told where there is a forward pass that takes any. */
static void print_costs(const outcome *of)
{
    const scene_times *times = &of->drawn.times;
    size_t bytes = scene_bytes(&of->placed->scene, asked.settings.how.tier);
    caustics_print(asked.words, &times->caustics, times->forward);
    fprintf(asked.words, "memory        %zu bytes: objects %zu, hierarchy %zu, photons %zu\n",
            bytes + times->bytes + times->caustics.bytes, bytes, times->bytes,
            times->caustics.bytes);
}

static void print_words(const outcome *of, double seconds)
{
    const scene_times *times = &of->drawn.times;
    if (!asked.quiet)
        print_summary(asked.certificate, shown(of)->width, shown(of)->height, seconds);
    if (!asked.quiet && of->heat.rgb)
        heat_print_key(asked.words, asked.heat, of->drawn.records,
                       (size_t)of->heat.width * (size_t)of->heat.height);
    if (asked.explain) {
        explain_features(asked.words, &of->placed->scene, &asked.settings.how);
        print_costs(of);
        explain_statistics(asked.words, &of->drawn.statistics, asked.settings.how.tier);
    }
    if (asked.time)
        json_print_line(times_json(of->placed, times, json_real(times->forward), of->write),
                        asked.words);
}

static bool draw_heat(outcome *of)
{
    const picture *image = &of->drawn.image;
    if (asked.heat == NO_HEAT ||
        heat_draw(asked.heat, of->drawn.records, image->width, image->height, &of->heat))
        return true;
    return complain(stderr, asked.scene, "no memory for this picture");
}

/* A black picture looks as if the program were broken. Its rays are counted then, once more. */
static void tell_of_black(const outcome *of)
{
    rendering again;
    render_settings counting = asked.settings;
    char *printable = rt_printable_name(asked.scene);
    const char *name = printable ? printable : "";
    counting.counted = true;
    counting.recorded = false;
    counting.integrator = INTEGRATOR_BACKWARD;
    if (asked.settings.counted) {
        blackness_explain(stderr, name, &of->placed->scene, &of->drawn.statistics);
    } else if (render_file_draw(asked.scene, of->placed, &counting, stderr, &again)) {
        blackness_explain(stderr, name, &of->placed->scene, &again.statistics);
        rendering_free(&again);
    }
    free(printable);
}

/* Whoever says how many expects some. */
static void tell_of_photons(const caustics_statistics *sent)
{
    if ((asked.settings.photons > 0 || asked.settings.seed > 0) && sent->state != CAUSTICS_ON &&
        sent->traced == 0)
        warn(stderr, asked.scene, "--%s changes nothing: %s",
             asked.settings.photons > 0 ? "photons" : "seed", caustics_why(sent->state));
}

/* CUT_GOES_ON with the picture; else an exit status, and nothing is left allocated. */
static int draw_all(const placed_scene *placed, rendering *drawn)
{
    const render_settings *settings = &asked.settings;
    if (!rendering_room(asked.scene, placed, settings, stderr, drawn))
        return EXIT_USAGE;
    int status = squares_do(asked.scene, placed, settings, drawn);
    if (status == CUT_GOES_ON && cut.way == CUT_NOT &&
        !rendering_draw(asked.scene, placed, settings, stderr, drawn))
        status = EXIT_USAGE;
    if (status != CUT_GOES_ON)
        rendering_free(drawn);
    return status;
}

int render_backward(const placed_scene *placed)
{
    outcome of = {.placed = placed};
    double started = progress_clock();
    int status = draw_all(placed, &of.drawn);
    if (status != CUT_GOES_ON)
        return status;
    status = draw_heat(&of) ? write_all(&of) : EXIT_OUTPUT;
    if (status == 0 && asked.settings.how.part.width == 0 && picture_is_black(&of.drawn.image))
        tell_of_black(&of);
    if (status == 0)
        tell_of_photons(&of.drawn.times.caustics);
    if (status == 0)
        print_words(&of, progress_clock() - started + placed->read + placed->place);
    picture_free(&of.heat);
    rendering_free(&of.drawn);
    return status;
}

/* From the lights: --integrator forward. */

#define BOUNCES_DEFAULT 16
#define FEW_PHOTONS 1000 /* fewer may well light nothing that is seen */

/* Light that does not fall off has no energy to be spread by further bounces. */
static int resolve_bounces(const placed_scene *placed, int *bounces)
{
    bool falls = placed->options.falloff == SURE_FALLOFF_INVERSE_SQUARE;
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
static int write_sum(const partial_film *sum, bool *black)
{
    picture image;
    bool written = !asked.share || partial_film_write(sum, asked.share, stderr);
    if (!partial_film_picture(sum, asked.scene, stderr, &image))
        return EXIT_OUTPUT;
    int status = write_pictures(&image);
    *black = picture_is_black(&image);
    picture_free(&image);
    return written ? status : EXIT_OUTPUT;
}

static void print_times(const placed_scene *placed, const forward_sum *done, double write)
{
    json_t *object = times_json(placed, &done->times, NULL, write);
    json_object_update_new(object, photons_json(&done->sum, forward_sum_seconds(done)));
    json_print_line(object, asked.words);
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
    bool black = false;
    int status = write_sum(&done->sum, &black);
    double now = progress_clock();
    if (status != 0)
        return status;
    if (!asked.quiet) {
        print_summary(asked.share, done->sum.sums.width, done->sum.sums.height,
                      now - started + placed->read + placed->place);
        photons_print(asked.words, &done->sum, forward_sum_seconds(done));
    }
    if (asked.explain)
        explain_features(asked.words, &placed->scene, &asked.settings.how);
    if (asked.time)
        print_times(placed, done, now - traced);
    const bool few =
        asked.share || asked.forward.how.aperture > 0 || done->sum.statistics.emitted < FEW_PHOTONS;
    if (black && !few && !done->interrupted)
        warn(stderr, asked.scene,
             "no point that photons lit is seen: an eye sees none in a mirror or through glass");
    if (done->interrupted)
        print_interrupted(&done->sum);
    return done->interrupted ? EXIT_INTERRUPTED : 0;
}

int render_photons(const placed_scene *placed)
{
    forward_plan *plan = &asked.forward;
    plan->scene = asked.scene;
    plan->placed = placed;
    plan->settings = &asked.settings;
    plan->how.seed = asked.settings.seed;
    double started = progress_clock();
    forward_sum done;
    int status = resolve_bounces(placed, &plan->how.bounces);
    if (status != 0)
        return status;
    status = forward_sum_begin(plan, stderr, &done) ? photons_do(plan, &done) : EXIT_USAGE;
    if (status == CUT_GOES_ON && cut.way == CUT_NOT && !forward_sum_fill(plan, stderr, &done))
        status = EXIT_USAGE;
    if (status == CUT_GOES_ON)
        status = finish(placed, &done, started);
    partial_film_free(&done.sum);
    return status;
}

/* Readers of the words for it. */

const char *cli_scene(const cli_option *row, const char *value)
{
    render_settings *settings = row->to;
    return rt_set_option(&settings->reading, &settings->reading_set, row->name, value);
}

/* Of "", which is no tier: the help text. */
const char *cli_drawn_tier(const cli_option *row, const char *value)
{
    static char help[256];
    if (*value != '\0')
        return cli_tier(row, value);
    snprintf(help, sizeof help, "whose functions decide what is seen: %s (default: %s)",
             cli_tier(row, value), sure_tier_name(((render_settings)RENDER_DEFAULTS).how.tier));
    return help;
}

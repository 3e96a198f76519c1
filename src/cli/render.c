#define _POSIX_C_SOURCE 200809L /* isatty, strcasecmp */

#include "commands.h"
#include "render_forward.h"
#include "render_request.h"

#include "../evidence/certificate.h"
#include "../evidence/explain.h"
#include "../support/progress.h"
#include "../scene/rt_notes.h"
#include "../support/atomic_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

/* Files. */

static bool is_same_file(const char *a, const char *b)
{
    struct stat of_a, of_b;
    return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev &&
           of_a.st_ino == of_b.st_ino;
}

/* Pictures' names have endings of their own, which tells these apart even before they are there. */
static bool has_ending(const char *path, const char *ending)
{
    size_t length = strlen(path), size = strlen(ending);
    return length >= size && strcasecmp(path + length - size, ending) == 0;
}

/* Of what no picture is: `what`, or NULL for none. */
static int check_other_path(const render_request *asked, const char *path, const char *what)
{
    if (!path)
        return 0;
    bool taken =
        has_ending(path, ".ppm") || has_ending(path, ".png") || is_same_file(path, asked->scene);
    for (int i = 0; i < asked->output_count; i++)
        taken = taken || is_same_file(path, asked->outputs[i]);
    if (taken) {
        fprintf(stderr, "%s: error: a %s may not take the place of a scene or picture\n", path,
                what);
        return EXIT_USAGE;
    }
    return atomic_file_possible(path, stderr) ? 0 : EXIT_OUTPUT;
}

static int check_outputs(const render_request *asked)
{
    for (int i = 0; i < asked->output_count; i++) {
        if (!picture_path_ok(asked->outputs[i], stderr))
            return EXIT_USAGE;
    }
    for (int i = 0; i < asked->output_count; i++) {
        if (!atomic_file_possible(asked->outputs[i], stderr))
            return EXIT_OUTPUT;
    }
    int status = check_other_path(asked, asked->certificate, "certificate");
    return status == 0 ? check_other_path(asked, asked->forward.share, "share") : status;
}

int render_write_pictures(const render_request *asked, const picture *image)
{
    for (int i = 0; i < asked->output_count; i++) {
        if (!picture_write(image, asked->outputs[i], stderr))
            return EXIT_OUTPUT;
    }
    return 0;
}

/* What is drawn and what is known of it. */
typedef struct {
    const render_request *asked;
    const placed_scene *placed;
    uint64_t hash; /* of the scene, for a certificate */
    rendering drawn;
    picture heat; /* rgb NULL where light was asked for */
    double write; /* seconds */
} outcome;

static int write_certificate(const outcome *of)
{
    const render_request *asked = of->asked;
    certificate said = {
        .scene = rt_printable_name(asked->scene),
        .hash = of->hash,
        .objects = of->placed->scene.object_count,
        .options = of->placed->options,
        .part = asked->settings.how.part,
        .tier = asked->settings.how.tier,
        .account = of->drawn.account,
        .records = of->drawn.records,
    };
    said.part.width = of->drawn.image.width;
    said.part.height = of->drawn.image.height;
    bool written = said.scene && certificate_write(&said, asked->certificate, stderr);
    if (!said.scene)
        fprintf(stderr, "%s: error: no memory\n", asked->certificate);
    free(said.scene);
    return written ? 0 : EXIT_OUTPUT;
}

static int write_all(outcome *of)
{
    double started = progress_clock();
    int status = render_write_pictures(of->asked, of->heat.rgb ? &of->heat : &of->drawn.image);
    if (status == 0 && of->asked->certificate)
        status = write_certificate(of);
    of->write = progress_clock() - started;
    return status;
}

/* Words about it. */

static void print_summary(const outcome *of, double seconds)
{
    const render_request *asked = of->asked;
    const picture *image = of->heat.rgb ? &of->heat : &of->drawn.image;
    for (int i = 0; i < asked->output_count; i++)
        printf("%s%s", i > 0 ? ", " : "", asked->outputs[i]);
    if (asked->certificate)
        printf(", %s", asked->certificate);
    printf(": %dx%d, %.2f s\n", image->width, image->height, seconds);
}

static void print_explanation(const outcome *of)
{
    const render_options *how = &of->asked->settings.how;
    scene_features features = scene_features_of(&of->placed->scene, how);
    explain_features(stdout, &features, how);
    explain_caustics(stdout, &of->drawn.times.caustics);
    explain_account(stdout, &of->drawn.account, how->tier);
}

static void print_times(const outcome *of)
{
    printf("{\"read\": %.6f, \"place\": %.6f, \"build\": %.6f, \"forward\": %.6f, \"frame\": %.6f, "
           "\"write\": %.6f, "
           "\"objects\": %zu, \"threads\": %d}\n",
           of->placed->read, of->placed->place, of->drawn.times.build, of->drawn.times.forward,
           of->drawn.times.frame, of->write, of->placed->scene.object_count,
           render_threads(&of->asked->settings.how));
}

static void print_words(const outcome *of, double seconds)
{
    if (!of->asked->quiet)
        print_summary(of, seconds);
    if (of->asked->explain)
        print_explanation(of);
    if (of->asked->time)
        print_times(of);
}

/* The way. */

static bool draw_heat(outcome *of)
{
    const picture *image = &of->drawn.image;
    if (of->asked->heat == NO_HEAT ||
        heat_draw(of->asked->heat, of->drawn.records, image->width, image->height, &of->heat))
        return true;
    fprintf(stderr, "%s: error: no memory for this picture\n", of->asked->scene);
    return false;
}

static int draw_placed(outcome *of)
{
    const render_request *asked = of->asked;
    double started = progress_clock();
    if (asked->certificate && !certificate_hash(asked->scene, stderr, &of->hash))
        return EXIT_USAGE;
    if (!render_file_draw(asked->scene, of->placed, &asked->settings, stderr, &of->drawn))
        return EXIT_USAGE;
    int status = draw_heat(of) ? write_all(of) : EXIT_OUTPUT;
    if (status == 0)
        print_words(of, progress_clock() - started + of->placed->read + of->placed->place);
    picture_free(&of->heat);
    rendering_free(&of->drawn);
    return status;
}

static int draw(const args *line, const render_request *asked)
{
    placed_scene placed;
    if (!render_file_place(asked->scene, &asked->settings, stderr, &placed))
        return EXIT_USAGE;
    int status = asked->settings.how.integrator == INTEGRATOR_FORWARD
                     ? render_forward_placed(line, asked, &placed)
                     : draw_placed(&(outcome){.asked = asked, .placed = &placed});
    placed_scene_free(&placed);
    return status;
}

static int answer(args *line, render_request *asked)
{
    int status = render_read_words(line, asked);
    if (status == 0 && asked->help) {
        render_print_help();
        return args_flush_output(line, 0);
    }
    if (status == 0)
        status = check_outputs(asked);
    if (status == 0) {
        asked->settings.how.progress = !asked->quiet && isatty(STDERR_FILENO);
        asked->settings.counted = asked->certificate || asked->explain;
        asked->settings.recorded = asked->certificate || asked->heat != NO_HEAT;
        asked->settings.how.clocked = asked->heat == HEAT_TIME && !asked->settings.counted;
        status = draw(line, asked);
    }
    return status == 0 || status == EXIT_INTERRUPTED ? args_flush_output(line, status) : status;
}

int command_render(int count, char **words)
{
    args line = {"surehit render", words, count, 0, false};
    render_request asked = {.heat = NO_HEAT, .settings = render_defaults()};
    asked.outputs = calloc((size_t)count + 1, sizeof *asked.outputs);
    if (!asked.outputs) {
        fputs("surehit render: error: no memory\n", stderr);
        return EXIT_OUTPUT;
    }
    int status = answer(&line, &asked);
    free(asked.outputs);
    return status;
}

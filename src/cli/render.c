#define _POSIX_C_SOURCE 200809L /* isatty, strcasecmp */

#include "args.h"
#include "commands.h"
#include "drawing.h"

#include "../tracer/certificate.h"
#include "../tracer/explain.h"
#include "../tracer/heat.h"
#include "../tracer/progress.h"
#include "../tracer/rt_notes.h"
#include "../tracer/visible.h"
#include "../tracer/whole_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    HELP,
    OUTPUT,
    QUIET,
    SAMPLES,
    TILE,
    CERTIFICATE,
    HEAT,
    EXPLAIN,
    TIME,
    NO_HIERARCHY,
    DRAWING
};
static const args_option options[] = {
    [HELP] = {"--help", false},   [OUTPUT] = {"-o", true},
    [QUIET] = {"--quiet", false}, [SAMPLES] = {"--samples", true},
    [TILE] = {"--tile", true},    [CERTIFICATE] = {"--certificate", true},
    [HEAT] = {"--heat", true},    [EXPLAIN] = {"--explain", false},
    [TIME] = {"--time", false},   [NO_HIERARCHY] = {"--no-hierarchy", false},
    [DRAWING] = DRAWING_OPTIONS,
};
#define OPTIONS (int)(sizeof options / sizeof *options)

#define NO_HEAT HEATS

typedef struct {
    bool help, quiet, explain, time;
    const char *scene;
    const char **outputs; /* room for every word */
    int output_count;
    const char *certificate; /* its path, or NULL */
    heat_kind heat;          /* NO_HEAT: light */
    render_settings settings;
} request;

static void print_help(void)
{
    fputs("Usage: surehit render SCENE.rt -o OUT.ppm|OUT.png [OPTION ...]\n"
          "\n"
          "Draws a scene. A picture appears whole or not at all.\n"
          "\n"
          "  -o FILE          the picture; may be given more than once\n",
          stdout);
    drawing_print_help();
    fputs("  --samples N      rays a pixel: 1, 4, 9, ... 4096\n"
          "  --tile X,Y,WxH   a part of the picture; 0,0 is the upper left corner\n"
          "  --certificate FILE  what each pixel sees, for `surehit check`\n"
          "  --heat KIND      false colours instead: the stage that told the hit, the error\n"
          "                   of t, or the time a pixel takes (stage, error, time)\n"
          "  --explain        which features the scene asks for, and what its rays met\n"
          "  --time           seconds and objects in one line of JSON\n"
          "  --no-hierarchy   every ray asks every object: the same picture, slower\n"
          "  --quiet          no progress bar and no line at the end\n"
          "\n"
          "How the scene is meant, default first; these win over its own `#!` lines:\n"
          "  --handedness right|left             --falloff none|inverse-square\n"
          "  --fov horizontal|vertical           --cylinder-position middle|base\n"
          "  --cone-position middle|apex|base    --skip-unknown: leave out unknown surfaces\n"
          "\n"
          "Exit status: 0 done; 1 output could not be written; 2 wrong usage or scene.\n",
          stdout);
}

/* The words. */

static int add_operand(const args *line, const char *word, request *asked)
{
    if (asked->scene)
        return args_wrong(line, "a second scene", word);
    asked->scene = word;
    return 0;
}

#define MOST_SIDE 64 /* whose square is MOST_SAMPLES */
#define MOST_SAMPLES 4096

/* The side of the square. */
static int set_samples(const args *line, const char *value, int *side)
{
    uint64_t samples;
    if (args_number(value, 1, MOST_SAMPLES, &samples)) {
        for (int i = 1; i <= MOST_SIDE; i++) {
            if ((uint64_t)i * (uint64_t)i != samples)
                continue;
            *side = i;
            return 0;
        }
    }
    return args_wrong_value(line, "--samples", value, "a square: 1, 4, 9, 16, ... 4096");
}

static int set_tile(const args *line, const char *value, picture_part *part)
{
    if (render_part_from(value, part))
        return 0;
    return args_wrong_value(line, "--tile", value, "X,Y,WxH, whole numbers such as 640,0,320x180");
}

static int set_heat(const args *line, const char *value, heat_kind *heat)
{
    if (heat_from_name(value, heat))
        return 0;
    return args_wrong_value(line, "--heat", value, "stage, error or time");
}

/* What is asked for by one option, and can't be had with another's value. */
static int clash(const args *line, const char *option, const char *other, const char *why)
{
    fprintf(stderr, "%s: error: %s does not go with %s: %s; see '%s --help'\n", line->command,
            option, other, why, line->command);
    return EXIT_USAGE;
}

/* A certificate and two of the heats tell what one ray of a tier that knows has seen. */
static int check_together(const args *line, const request *asked)
{
    const render_options *how = &asked->settings.how;
    char first[32], second[32];
    if (!asked->certificate && asked->heat != HEAT_STAGE && asked->heat != HEAT_ERROR)
        return 0;
    snprintf(first, sizeof first, "%s%s", asked->certificate ? "--certificate" : "--heat ",
             asked->certificate ? "" : heat_name(asked->heat));
    snprintf(second, sizeof second, "--samples %d", how->samples * how->samples);
    if (how->samples > 1)
        return clash(line, first, second, "it is about one ray a pixel");
    snprintf(second, sizeof second, "--tier %s", sure_tier_name(how->tier));
    if (!is_sure(how->tier))
        return clash(line, first, second, "that tier promises nothing");
    return 0;
}

/* Returns the exit status, 0 to go on. */
static int read_words(args *line, request *asked)
{
    const char *value;
    render_options *how = &asked->settings.how;
    int status = 0, option;
    while (status == 0 && (option = args_next(line, options, OPTIONS, &value)) != ARGS_END) {
        switch (option) {
        case HELP: asked->help = true; return 0;
        case OUTPUT: asked->outputs[asked->output_count++] = value; break;
        case QUIET: asked->quiet = true; break;
        case SAMPLES: status = set_samples(line, value, &how->samples); break;
        case TILE: status = set_tile(line, value, &how->part); break;
        case CERTIFICATE: asked->certificate = value; break;
        case HEAT: status = set_heat(line, value, &asked->heat); break;
        case EXPLAIN: asked->explain = true; break;
        case TIME: asked->time = true; break;
        case NO_HIERARCHY: how->without_bvh = true; break;
        case ARGS_OPERAND: status = add_operand(line, value, asked); break;
        case ARGS_WRONG: status = EXIT_USAGE; break;
        default: status = drawing_set(line, options[option].name, value, &asked->settings);
        }
    }
    if (status == 0 && !asked->scene)
        status = args_wrong(line, "missing", "SCENE.rt");
    if (status == 0 && asked->output_count == 0)
        status = args_wrong(line, "missing", "-o FILE");
    return status == 0 ? check_together(line, asked) : status;
}

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

static int check_certificate_path(const request *asked)
{
    const char *path = asked->certificate;
    bool taken =
        has_ending(path, ".ppm") || has_ending(path, ".png") || is_same_file(path, asked->scene);
    for (int i = 0; i < asked->output_count; i++)
        taken = taken || is_same_file(path, asked->outputs[i]);
    if (taken) {
        fprintf(stderr, "%s: error: a certificate may not take the place of a scene or picture\n",
                path);
        return EXIT_USAGE;
    }
    return whole_file_possible(path, stderr) ? 0 : EXIT_OUTPUT;
}

static int check_outputs(const request *asked)
{
    for (int i = 0; i < asked->output_count; i++) {
        if (!picture_path_ok(asked->outputs[i], stderr))
            return EXIT_USAGE;
    }
    for (int i = 0; i < asked->output_count; i++) {
        if (!whole_file_possible(asked->outputs[i], stderr))
            return EXIT_OUTPUT;
    }
    return asked->certificate ? check_certificate_path(asked) : 0;
}

static int write_pictures(const request *asked, const picture *image)
{
    for (int i = 0; i < asked->output_count; i++) {
        if (!picture_write(image, asked->outputs[i], stderr))
            return EXIT_OUTPUT;
    }
    return 0;
}

/* What is drawn and what is known of it. */
typedef struct {
    const request *asked;
    const placed_scene *placed;
    uint64_t hash; /* of the scene, for a certificate */
    rendering drawn;
    picture heat; /* rgb NULL where light was asked for */
    double write; /* seconds */
} outcome;

static int write_certificate(const outcome *of)
{
    const request *asked = of->asked;
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
    int status = write_pictures(of->asked, of->heat.rgb ? &of->heat : &of->drawn.image);
    if (status == 0 && of->asked->certificate)
        status = write_certificate(of);
    of->write = progress_clock() - started;
    return status;
}

/* Words about it. */

static void print_summary(const outcome *of, double seconds)
{
    const request *asked = of->asked;
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
    explain_account(stdout, &of->drawn.account, how->tier);
}

static void print_times(const outcome *of)
{
    printf("{\"read\": %.6f, \"place\": %.6f, \"build\": %.6f, \"frame\": %.6f, \"write\": %.6f, "
           "\"objects\": %zu, \"threads\": %d}\n",
           of->placed->read, of->placed->place, of->drawn.times.build, of->drawn.times.frame,
           of->write, of->placed->scene.object_count, render_threads(&of->asked->settings.how));
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
    const request *asked = of->asked;
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

static int draw(const request *asked)
{
    placed_scene placed;
    if (!render_file_place(asked->scene, &asked->settings, stderr, &placed))
        return EXIT_USAGE;
    int status = draw_placed(&(outcome){.asked = asked, .placed = &placed});
    placed_scene_free(&placed);
    return status;
}

static int answer(args *line, request *asked)
{
    int status = read_words(line, asked);
    if (status == 0 && asked->help) {
        print_help();
        return args_flush_output(line, 0);
    }
    if (status == 0)
        status = check_outputs(asked);
    if (status == 0) {
        asked->settings.how.progress = !asked->quiet && isatty(STDERR_FILENO);
        asked->settings.counted = asked->certificate || asked->explain;
        asked->settings.recorded = asked->certificate || asked->heat != NO_HEAT;
        asked->settings.how.clocked = asked->heat == HEAT_TIME && !asked->settings.counted;
        status = draw(asked);
    }
    return status == 0 ? args_flush_output(line, 0) : status;
}

int command_render(int count, char **words)
{
    args line = {"surehit render", words, count, 0, false};
    request asked = {.heat = NO_HEAT, .settings = render_defaults()};
    asked.outputs = calloc((size_t)count + 1, sizeof *asked.outputs);
    if (!asked.outputs) {
        fputs("surehit render: error: no memory\n", stderr);
        return EXIT_OUTPUT;
    }
    int status = answer(&line, &asked);
    free(asked.outputs);
    return status;
}

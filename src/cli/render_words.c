#include "drawing.h"
#include "render_request.h"

#include "../photons/partial_film.h"
#include "../tracer/visible.h"

#include <inttypes.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    INTEGRATOR,
    PHOTONS,
    SEED,
    FIRST,
    BOUNCES,
    APERTURE,
    SHARE,
    CONTINUE,
    DRAWING
};
static const args_option options[] = {
    [HELP] = {"--help", false},
    [OUTPUT] = {"-o", true},
    [QUIET] = {"--quiet", false},
    [SAMPLES] = {"--samples", true},
    [TILE] = {"--tile", true},
    [CERTIFICATE] = {"--certificate", true},
    [HEAT] = {"--heat", true},
    [EXPLAIN] = {"--explain", false},
    [TIME] = {"--time", false},
    [NO_HIERARCHY] = {"--no-hierarchy", false},
    [INTEGRATOR] = {"--integrator", true},
    [PHOTONS] = {"--photons", true},
    [SEED] = {"--seed", true},
    [FIRST] = {"--first", true},
    [BOUNCES] = {"--bounces", true},
    [APERTURE] = {"--aperture", true},
    [SHARE] = {"--share", true},
    [CONTINUE] = {"--continue", true},
    [DRAWING] = DRAWING_OPTIONS,
};
#define OPTIONS (int)(sizeof options / sizeof *options)

static const char *const integrators[] = {
    [INTEGRATOR_AUTO] = "auto",
    [INTEGRATOR_BACKWARD] = "backward",
    [INTEGRATOR_FORWARD] = "forward",
    [INTEGRATOR_MIXED] = "mixed",
};
#define INTEGRATORS (int)(sizeof integrators / sizeof *integrators)

void render_print_help(void)
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
          "Which way light is followed:\n"
          "  --integrator KIND  backward, from the eye; forward, from the lights; mixed,\n"
          "                   backward but for light through mirrors and glass; auto\n"
          "                   (default), mixed where these need it and light falls off\n"
          "  --photons N      that leave the lights (forward: 10000000)\n"
          "  --seed N         of their random numbers (0)\n"
          "forward only:\n"
          "  --first I        number of the first photon (0)\n"
          "  --bounces N      matte surfaces that a photon may light (16; with --falloff\n"
          "                   none 1)\n"
          "  --aperture R     radius of an opening that they must enter; 0 is a pinhole\n"
          "  --share FILE     the exact sums, for `surehit merge` and --continue\n"
          "  --continue FILE  leaves out the photons that this share has, and adds it\n"
          "\n"
          "How the scene is meant, default first; these win over its own `#!` lines:\n"
          "  --handedness right|left             --falloff none|inverse-square\n"
          "  --fov horizontal|vertical           --cylinder-position middle|base\n"
          "  --cone-position middle|apex|base    --skip-unknown: leave out unknown surfaces\n"
          "\n"
          "Exit status: 0 done; 1 output could not be written; 2 wrong usage or scene;\n"
          "130 interrupted, forward only: the photons that were traced are in picture and\n"
          "share.\n",
          stdout);
}

static int add_operand(const args *line, const char *word, render_request *asked)
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

static int set_integrator(const args *line, const char *value, integrator_kind *kind)
{
    for (int i = 0; i < INTEGRATORS; i++) {
        if (strcmp(value, integrators[i]) != 0)
            continue;
        *kind = (integrator_kind)i;
        return 0;
    }
    return args_wrong_value(line, "--integrator", value, "auto, backward, forward or mixed");
}

static int set_number(const args *line, const char *name, const char *value, uint64_t least,
                      uint64_t most, uint64_t *number)
{
    char expected[80];
    if (args_number(value, least, most, number))
        return 0;
    snprintf(expected, sizeof expected, "a whole number from %" PRIu64 " to %" PRIu64, least, most);
    return args_wrong_value(line, name, value, expected);
}

static int set_bounces(const args *line, const char *value, int *bounces)
{
    uint64_t number = 0;
    int status = set_number(line, "--bounces", value, 1, 1000000, &number);
    *bounces = (int)number;
    return status;
}

static int set_aperture(const args *line, const char *value, double *radius)
{
    char *end;
    *radius = strtod(value, &end);
    bool plain = value[strspn(value, "0123456789.eE+-")] == '\0' && *value != '-';
    if (plain && end != value && *end == '\0' && isfinite(*radius))
        return 0;
    return args_wrong_value(line, "--aperture", value, "a radius such as 0.05");
}

int render_clash(const args *line, const char *option, const char *other, const char *why)
{
    fprintf(stderr, "%s: error: %s does not go with %s: %s; see '%s --help'\n", line->command,
            option, other, why, line->command);
    return EXIT_USAGE;
}

/* A certificate and two of the heats tell what one ray of a tier that knows has seen. */
static int check_one_ray(const args *line, const render_request *asked)
{
    const render_options *how = &asked->settings.how;
    char first[32], second[32];
    if (!asked->certificate && asked->heat != HEAT_STAGE && asked->heat != HEAT_ERROR)
        return 0;
    snprintf(first, sizeof first, "%s%s", asked->certificate ? "--certificate" : "--heat ",
             asked->certificate ? "" : heat_name(asked->heat));
    snprintf(second, sizeof second, "--samples %d", how->samples * how->samples);
    if (how->samples > 1)
        return render_clash(line, first, second, "it is about one ray a pixel");
    snprintf(second, sizeof second, "--tier %s", sure_tier_name(how->tier));
    if (!is_sure(how->tier))
        return render_clash(line, first, second, "that tier promises nothing");
    return 0;
}

/* Options that have no meaning with an integrator. */
static int check_integrator(const args *line, const bool given[], integrator_kind kind)
{
    static const int pixels[] = {SAMPLES, TILE, CERTIFICATE, HEAT, -1};
    static const int photons[] = {PHOTONS, SEED, -1};
    static const int ways[] = {FIRST, BOUNCES, APERTURE, SHARE, CONTINUE, -1};
    static const char rays[] = "it is about rays from the eye through pixels";
    static const char none[] = "it is about photons";
    static const char eye[] = "it is about photons that go to the eye";
    const struct {
        bool applies;
        const int *options;
        const char *why;
    } rules[] = {
        {kind == INTEGRATOR_FORWARD, pixels, rays},
        {kind == INTEGRATOR_BACKWARD, photons, none},
        {kind != INTEGRATOR_FORWARD, ways, eye},
    };
    char other[32];
    snprintf(other, sizeof other, "--integrator %s", integrators[kind]);
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        for (const int *option = rules[i].options; rules[i].applies && *option >= 0; option++) {
            if (given[*option])
                return render_clash(line, options[*option].name, other, rules[i].why);
        }
    }
    return 0;
}

static int check_together(const args *line, const render_request *asked, const bool given[])
{
    int status = check_integrator(line, given, asked->settings.how.integrator);
    if (status != 0)
        return status;
    if (asked->forward.first > SHARE_PHOTONS_MOST - asked->settings.how.photons)
        return render_clash(line, "--first", "--photons", "there are no more than 2^56 photons");
    return check_one_ray(line, asked);
}

/* Returns the exit status, 0 to go on. */
static int read_word(const args *line, int option, const char *value, render_request *asked)
{
    render_options *how = &asked->settings.how;
    forward_request *forward = &asked->forward;
    switch (option) {
    case HELP: asked->help = true; return 0;
    case OUTPUT: asked->outputs[asked->output_count++] = value; return 0;
    case QUIET: asked->quiet = true; return 0;
    case SAMPLES: return set_samples(line, value, &how->samples);
    case TILE: return set_tile(line, value, &how->part);
    case CERTIFICATE: asked->certificate = value; return 0;
    case HEAT: return set_heat(line, value, &asked->heat);
    case EXPLAIN: asked->explain = true; return 0;
    case TIME: asked->time = true; return 0;
    case NO_HIERARCHY: how->without_bvh = true; return 0;
    case INTEGRATOR: return set_integrator(line, value, &how->integrator);
    case PHOTONS: return set_number(line, "--photons", value, 1, SHARE_PHOTONS_MOST, &how->photons);
    case SEED: return set_number(line, "--seed", value, 0, UINT64_MAX, &how->seed);
    case FIRST:
        return set_number(line, "--first", value, 0, SHARE_PHOTONS_MOST - 1, &forward->first);
    case BOUNCES: return set_bounces(line, value, &forward->bounces);
    case APERTURE: return set_aperture(line, value, &forward->aperture);
    case SHARE: forward->share = value; return 0;
    case CONTINUE: forward->from = value; return 0;
    case ARGS_OPERAND: return add_operand(line, value, asked);
    case ARGS_WRONG: return EXIT_USAGE;
    default: return drawing_set(line, options[option].name, value, &asked->settings);
    }
}

int render_read_words(args *line, render_request *asked)
{
    bool given[OPTIONS] = {false};
    const char *value;
    int status = 0, option;
    while (status == 0 && (option = args_next(line, options, OPTIONS, &value)) != ARGS_END) {
        status = read_word(line, option, value, asked);
        if (option >= 0)
            given[option] = true;
        if (asked->help)
            return status;
    }
    if (status == 0 && !asked->scene)
        status = args_wrong(line, "missing", "SCENE.rt");
    if (status == 0 && asked->output_count == 0)
        status = args_wrong(line, "missing", "-o FILE");
    return status == 0 ? check_together(line, asked, given) : status;
}

/* SPDX-License-Identifier: MIT */
#include "render.h"

#include "../support/complain.h"
#include "../support/folder.h"
#include "../support/pieces/cut.h"
#include "../tracer/visible.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

render_request asked = {.heat = NO_HEAT, .settings = RENDER_DEFAULTS};

/* Files. */

/* A share that is gone on with may be the one that is written. */
static bool goes_on(void)
{
    const char *from = asked.forward.from;
    return from && asked.share &&
           (strcmp(from, asked.share) == 0 || folder_is_same_file(from, asked.share));
}

static int check_outputs(void)
{
    const char *outputs[CLI_LIST_MOST + 2], *inputs[] = {asked.scene, asked.forward.from};
    const int count = asked.outputs.count;
    int piped = 0;
    for (int i = 0; i < count; i++) {
        const char *path = asked.outputs.texts[i];
        if (!picture_path_ok(path, stderr))
            return EXIT_USAGE;
        outputs[i] = picture_is_stdout(path) ? NULL : path;
        piped += !outputs[i];
    }
    if (piped > 1)
        return cli_wrong("one picture goes to standard output, not %d", piped);
    asked.words = piped ? stderr : stdout;
    outputs[count] = asked.certificate;
    outputs[count + 1] = asked.share;
    const cli_paths all = {outputs, inputs, count + 2, goes_on() ? 1 : 2};
    bool named = picture_is_other(asked.certificate, "certificate", stderr) &&
                 picture_is_other(asked.share, "share", stderr);
    return named ? cli_paths_check(&all) : EXIT_USAGE;
}

/* Values. */

/* The side of a square of rays. */
static const char *read_samples(const cli_option *row, const char *value)
{
    int samples = 0;
    const cli_option whole = {.to = &samples, .least = 1, .most = row->most};
    const char *expected = cli_int(&whole, value);
    int side = (int)sqrt(samples);
    if (expected || side * side != samples)
        return "a square: 1, 4, 9, 16, ... 4096";
    *(int *)row->to = side;
    return NULL;
}

static const char *read_tile(const cli_option *row, const char *value)
{
    return render_part_from(value, row->to) ? NULL : "X,Y,WxH, whole numbers such as 640,0,320x180";
}

static const char *read_radius(const cli_option *row, const char *value)
{
    char *end;
    errno = 0;
    double radius = strtod(value, &end);
    bool plain = value[strspn(value, "0123456789.eE+-")] == '\0' && *value != '-';
    if (!plain || end == value || *end != '\0' || !isfinite(radius) ||
        (radius == 0 && errno == ERANGE))
        return "a radius such as 0.05";
    *(double *)row->to = radius;
    return NULL;
}

/* What goes together. */

static const char *const integrators[] = {
    [INTEGRATOR_AUTO] = "auto",
    [INTEGRATOR_BACKWARD] = "backward",
    [INTEGRATOR_FORWARD] = "forward",
    [INTEGRATOR_MIXED] = "mixed",
    NULL,
};

/* An option that was given of each kind, or NULL. */
static struct {
    const char *pixel, *photon, *forward, *depth;
} given;

/* Options that have no meaning with an integrator. */
static int check_integrator(void)
{
    integrator_kind kind = asked.settings.integrator;
    const struct {
        bool applies;
        const char *option, *why;
    } rules[] = {
        {kind == INTEGRATOR_FORWARD, given.pixel, "it is about rays from the eye through pixels"},
        {kind == INTEGRATOR_BACKWARD, given.photon, "it is about photons"},
        {kind != INTEGRATOR_FORWARD, given.forward, "it is about photons that go to the eye"},
    };
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        if (rules[i].applies && rules[i].option)
            return cli_wrong("--%s does not go with --integrator %s: %s", rules[i].option,
                             integrators[kind], rules[i].why);
    }
    return 0;
}

/* A certificate and two of the heats tell what one ray of a tier that knows has seen. */
static int check_one_ray(void)
{
    const render_options *how = &asked.settings.how;
    const char *option = asked.certificate ? "certificate" : "heat ";
    const char *kind = asked.certificate ? "" : heat_names[asked.heat];
    if (!asked.certificate && asked.heat != HEAT_STAGE && asked.heat != HEAT_ERROR)
        return 0;
    if (how->samples > 1)
        return cli_wrong("--%s%s does not go with --samples %d: it is about one ray a pixel",
                         option, kind, how->samples * how->samples);
    if (!is_sure(how->tier))
        return cli_wrong("--%s%s does not go with --tier %s: that tier promises nothing", option,
                         kind, sure_tier_name(how->tier));
    return 0;
}

/* A picture in pieces has no time of its own, nor have its pixels, and shares of its photons that
 * are made elsewhere are not its own. Each of them reads the scene. */
static int check_cut(void)
{
    const char *option = asked.time                ? "time"
                         : asked.heat == HEAT_TIME ? "heat time"
                         : asked.forward.from      ? "continue"
                                                   : NULL;
    if (cut.way == CUT_NOT)
        return 0;
    if (option)
        return cli_wrong("--%s does not go with pieces", option);
    return file_is_kept(asked.scene, stderr) ? 0 : EXIT_USAGE;
}

static int check_together(void)
{
    bool drawn = cut.way == CUT_NOT || cut.way == CUT_MERGE;
    if (drawn && asked.outputs.count == 0)
        return cli_wrong("missing '-o FILE'");
    int status = check_integrator();
    if (status == 0)
        status = check_cut();
    if (status != 0)
        return status;
    if (given.depth && (asked.share || asked.forward.from))
        return cli_wrong("--depth does not go with --%s: a share says nothing of it",
                         asked.share ? "share" : "continue");
    if (asked.forward.first > RANGES_MOST - asked.settings.photons)
        return cli_wrong("--first does not go with --photons: there are no more than 2^56 photons");
    return check_one_ray();
}

static int draw(void)
{
    placed_scene placed;
    render_settings *settings = &asked.settings;
    settings->how.progress = !asked.quiet && cut.way == CUT_NOT;
    settings->counted = asked.certificate || asked.explain;
    settings->recorded = asked.certificate || asked.heat != NO_HEAT;
    settings->how.clocked = asked.heat == HEAT_TIME && !settings->counted;
    if (!render_file_place(asked.scene, settings, stderr, &placed))
        return EXIT_USAGE;
    if (given.depth)
        placed.scene.depth = asked.depth;
    int status = settings->integrator == INTEGRATOR_FORWARD ? render_photons(&placed)
                                                            : render_backward(&placed);
    placement_free(&placed.scene);
    return status;
}

static int run(void)
{
    asked.scene = cli_operands[0];
    int status = check_together();
    if (status == 0 && cut.way != CUT_WORK) /* which has none of them */
        status = check_outputs();
    return status == 0 ? draw() : status;
}

static const cli_option options[] = {
    {"o", "FILE", "the picture, or - for a PPM on standard output; may be given more than once",
     cli_texts, .to = &asked.outputs},
    CLI_SIZE(&asked.settings),
    CLI_DRAWN_TIER(&asked.settings.how.tier),
    CLI_THREADS(&asked.settings.how.threads),
    {"samples", "N", "rays a pixel: 1, 4, 9, ... 4096", read_samples,
     .to = &asked.settings.how.samples, .most = 4096, .given = &given.pixel},
    {"depth", "N", "mirrors and glass that follow one another (8)", cli_int, .to = &asked.depth,
     .most = 100, .given = &given.depth},
    {"tile", "X,Y,WxH", "a part of the picture; 0,0 is the upper left corner", read_tile,
     .to = &asked.settings.how.part, .given = &given.pixel},
    {"certificate", "FILE", "what each pixel sees, for `surehit check`", cli_text,
     .to = &asked.certificate, .given = &given.pixel},
    {"heat", "KIND",
     "false colours: the stage that decided the hit, the error of t, or the time a pixel "
     "takes (stage, error, time)",
     cli_word, .to = &asked.heat, .words = heat_names, .given = &given.pixel},
    {"explain", NULL, "which features the scene asks for, and what its rays met", cli_flag,
     .to = &asked.explain},
    {"time", NULL, "seconds, bytes, objects: one line of JSON", cli_flag, .to = &asked.time},
    {"no-hierarchy", NULL, "every ray asks every object: the same picture, slower", cli_flag,
     .to = &asked.settings.how.without_bvh},
    {"quiet", NULL, "no progress bar and no line at the end", cli_flag, .to = &asked.quiet},
    {NULL, .help = "Which way light is followed:"},
    {"integrator", "KIND",
     "backward, from the eye; forward, from the lights; mixed, backward but for light through "
     "mirrors and glass; auto (default), mixed where these need it and light falls off",
     cli_word, .to = &asked.settings.integrator, .words = integrators},
    {"photons", "N", "forward 10000000; else as the picture asks", cli_number,
     .to = &asked.settings.photons, .least = 1, .most = RANGES_MOST, .given = &given.photon},
    {"seed", "N", "of their random numbers (0)", cli_number, .to = &asked.settings.seed,
     .most = UINT64_MAX, .given = &given.photon},
    {NULL, .help = "forward only:"},
    {"first", "I", "number of the first photon (0)", cli_number, .to = &asked.forward.first,
     .most = RANGES_MOST - 1, .given = &given.forward},
    {"bounces", "N", "matte surfaces that a photon may light (16; with --falloff none 1)", cli_int,
     .to = &asked.forward.how.bounces, .least = 1, .most = 1000000, .given = &given.forward},
    {"aperture", "R", "radius of an opening that they must enter; 0 is a pinhole", read_radius,
     .to = &asked.forward.how.aperture, .given = &given.forward},
    {"share", "FILE", "the exact sums, for `surehit merge` and --continue", cli_text,
     .to = &asked.share, .given = &given.forward},
    {"continue", "FILE", "leaves out the photons that this share has, and adds it", cli_text,
     .to = &asked.forward.from, .given = &given.forward},
    CLI_MEANINGS(&asked.settings),
    {0},
};

const cli_command command_render = {
    .name = "surehit render",
    .summary = "draw a scene (.rt) into a picture (.ppm, .png)",
    .usage = "SCENE.rt -o OUT.ppm|OUT.png [OPTION ...]",
    .about = "Draws a scene. A picture appears whole or not at all.",
    .options = options,
    .operands = "SCENE.rt",
    .most_operands = 1,
    .cut_output = "-o",
    .statuses = "0 done; 1 output could not be written; 2 wrong usage or scene;\n"
                "130 interrupted, forward only: the photons that were traced are in picture\n"
                "and share.",
    .run = run,
};

#define _POSIX_C_SOURCE 200809L /* isatty */

#include "args.h"
#include "commands.h"

#include "../tracer/picture.h"
#include "../tracer/placement.h"
#include "../tracer/progress.h"
#include "../tracer/render.h"
#include "../tracer/rt.h"
#include "../tracer/whole_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define MOST_THREADS 1024
#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)

enum { HELP, OUTPUT, QUIET, THREADS, TIER, SCENE_OPTIONS };

/* From SCENE_OPTIONS on: what rt_set_option knows. */
static const args_option options[] = {
    [HELP] = {"--help", false},
    [OUTPUT] = {"-o", true},
    [QUIET] = {"--quiet", false},
    [THREADS] = {"--threads", true},
    [TIER] = {"--tier", true},
    [SCENE_OPTIONS] = {"--size", true},
    {"--handedness", true},
    {"--fov", true},
    {"--cylinder-position", true},
    {"--cone-position", true},
    {"--falloff", true},
    {"--skip-unknown", false},
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    bool help, quiet;
    const char *scene;
    const char **outputs; /* room for every word */
    int output_count;
    render_options how;
    rt_options reading;
    rt_options_set reading_set;
} request;

static void print_help(void)
{
    fputs("Usage: surehit render SCENE.rt -o OUT.ppm|OUT.png [OPTION ...]\n"
          "\n"
          "Draws a scene. A picture appears whole or not at all.\n"
          "\n"
          "  -o FILE          the picture; may be given more than once\n"
          "  --size WxH       pixels (default 1280x720, or the scene's R line)\n"
          "  --tier TIER      the functions that decide what is seen:\n"
          "                  ", stdout);
    for (int tier = 0; tier < SURE_TIERS; tier++)
        printf(" %s%s", sure_tier_name((sure_tier)tier),
               tier == SURE_TIER_TEXTBOOK ? " (default)" : "");
    fputs("\n"
          "  --threads N      1 to " TEXT(MOST_THREADS) " (default: one a core); "
          "the picture stays the same\n"
          "  --quiet          no progress bar and no line at the end\n"
          "\n"
          "How the scene is meant, default first; these win over its own `#!` lines:\n"
          "  --handedness right|left\n"
          "  --fov horizontal|vertical\n"
          "  --cylinder-position middle|base\n"
          "  --cone-position middle|apex|base\n"
          "  --falloff none|inverse-square\n"
          "  --skip-unknown   leave out surfaces of unknown kind\n"
          "\n"
          "Exit status: 0 done; 1 output could not be written; 2 wrong usage or scene.\n", stdout);
}

static int add_operand(const args *line, const char *word, request *asked)
{
    if (asked->scene)
        return args_wrong(line, "a second scene", word);
    asked->scene = word;
    return 0;
}

static int set_threads(const args *line, const char *value, request *asked)
{
    uint64_t threads;
    if (!args_number(value, 1, MOST_THREADS, &threads))
        return args_wrong_value(line, "--threads", value,
                                "a whole number from 1 to " TEXT(MOST_THREADS));
    asked->how.threads = (int)threads;
    return 0;
}

static int set_tier(const args *line, const char *value, request *asked)
{
    if (!sure_tier_from_name(value, &asked->how.tier))
        return args_wrong_value(line, "--tier", value,
                                "float32, textbook, stable, certain or exact");
    return 0;
}

static int set_scene_option(const args *line, int option, const char *value, request *asked)
{
    const char *name = options[option].name;
    const char *expected =
        rt_set_option(&asked->reading, &asked->reading_set, name + 2, value);
    return expected ? args_wrong_value(line, name, value, expected) : 0;
}

/* Returns the exit status, 0 to go on. */
static int read_words(args *line, request *asked)
{
    const char *value;
    int status = 0, option;
    while (status == 0 && (option = args_next(line, options, OPTIONS, &value)) != ARGS_END) {
        switch (option) {
        case HELP: asked->help = true; return 0;
        case OUTPUT: asked->outputs[asked->output_count++] = value; break;
        case QUIET: asked->quiet = true; break;
        case THREADS: status = set_threads(line, value, asked); break;
        case TIER: status = set_tier(line, value, asked); break;
        case ARGS_OPERAND: status = add_operand(line, value, asked); break;
        case ARGS_WRONG: status = EXIT_USAGE; break;
        default: status = set_scene_option(line, option, value, asked);
        }
    }
    if (status == 0 && !asked->scene)
        status = args_wrong(line, "missing", "SCENE.rt");
    if (status == 0 && asked->output_count == 0)
        status = args_wrong(line, "missing", "-o FILE");
    return status;
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
    return 0;
}

static int write_outputs(const request *asked, const picture *image)
{
    for (int i = 0; i < asked->output_count; i++) {
        if (!picture_write(image, asked->outputs[i], stderr))
            return EXIT_OUTPUT;
    }
    return 0;
}

static void print_summary(const request *asked, const picture *image, double seconds)
{
    for (int i = 0; i < asked->output_count; i++)
        printf("%s%s", i > 0 ? ", " : "", asked->outputs[i]);
    printf(": %dx%d, %.2f s\n", image->width, image->height, seconds);
}

static int draw(const request *asked, const sure_scene *scene)
{
    double started = progress_clock();
    picture image;
    if (!picture_new(scene->width, scene->height, &image)) {
        fprintf(stderr, "surehit render: error: no memory for %dx%d pixels\n", scene->width,
                scene->height);
        return EXIT_OUTPUT;
    }
    render(scene, &asked->how, &image);
    int status = write_outputs(asked, &image);
    if (status == 0 && !asked->quiet)
        print_summary(asked, &image, progress_clock() - started);
    picture_free(&image);
    return status;
}

static int read_and_draw(const request *asked)
{
    rt_scene file;
    if (!rt_read(asked->scene, &asked->reading, &asked->reading_set, stderr, &file))
        return EXIT_USAGE;
    sure_scene scene;
    int status = EXIT_USAGE;
    if (placement(&file, stderr, &scene)) {
        status = draw(asked, &scene);
        placement_free(&scene);
    }
    rt_scene_free(&file);
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
        asked->how.progress = !asked->quiet && isatty(STDERR_FILENO);
        status = read_and_draw(asked);
    }
    return status == 0 ? args_flush_output(line, 0) : status;
}

int command_render(int count, char **words)
{
    args line = {"surehit render", words, count, 0, false};
    request asked = {.how.tier = SURE_TIER_TEXTBOOK, .reading = rt_default_options()};
    asked.outputs = calloc((size_t)count + 1, sizeof *asked.outputs);
    if (!asked.outputs) {
        fputs("surehit render: error: no memory\n", stderr);
        return EXIT_OUTPUT;
    }
    int status = answer(&line, &asked);
    free(asked.outputs);
    return status;
}

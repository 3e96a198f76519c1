#include "render.h"

#include "../evidence/certificate.h"
#include "../evidence/explain.h"
#include "../photons/map/caustics.h"
#include "../scene/rt_notes.h"
#include "../support/json_file.h"
#include "../support/progress.h"

#include <stdlib.h>

/* What is drawn and what is known of it. */
typedef struct {
    const placed_scene *placed;
    uint64_t hash; /* of the scene, for a certificate */
    rendering drawn;
    picture heat; /* rgb NULL where light was asked for */
    double write; /* seconds */
} outcome;

static int write_certificate(const outcome *of)
{
    certificate said = {
        .scene = rt_printable_name(asked.scene),
        .hash = of->hash,
        .objects = of->placed->scene.object_count,
        .options = of->placed->options,
        .part = asked.settings.how.part,
        .tier = asked.settings.how.tier,
        .statistics = of->drawn.statistics,
        .records = of->drawn.records,
    };
    said.part.width = of->drawn.image.width;
    said.part.height = of->drawn.image.height;
    bool written = said.scene && certificate_write(&said, asked.certificate, stderr);
    if (!said.scene)
        fprintf(stderr, "%s: error: no memory\n", asked.certificate);
    free(said.scene);
    return written ? 0 : EXIT_OUTPUT;
}

static const picture *shown(const outcome *of)
{
    return of->heat.rgb ? &of->heat : &of->drawn.image;
}

static int write_all(outcome *of)
{
    double started = progress_clock();
    int status = render_write_pictures(shown(of));
    if (status == 0 && asked.certificate)
        status = write_certificate(of);
    of->write = progress_clock() - started;
    return status;
}

static void print_words(const outcome *of, double seconds)
{
    const scene_times *times = &of->drawn.times;
    if (!asked.quiet)
        render_print_summary(asked.certificate, shown(of)->width, shown(of)->height, seconds);
    if (!asked.quiet && of->heat.rgb)
        heat_print_key(stdout, asked.heat, of->drawn.records,
                       (size_t)of->heat.width * (size_t)of->heat.height);
    if (asked.explain) {
        explain_features(stdout, &of->placed->scene, &asked.settings.how);
        caustics_print(stdout, &times->caustics);
        explain_statistics(stdout, &of->drawn.statistics, asked.settings.how.tier);
    }
    if (asked.time)
        json_print_line(render_times_json(of->placed, times->build, json_real(times->forward),
                                          times->frame, of->write),
                        stdout);
}

static bool draw_heat(outcome *of)
{
    const picture *image = &of->drawn.image;
    if (asked.heat == NO_HEAT ||
        heat_draw(asked.heat, of->drawn.records, image->width, image->height, &of->heat))
        return true;
    fprintf(stderr, "%s: error: no memory for this picture\n", asked.scene);
    return false;
}

int render_backward(const placed_scene *placed)
{
    outcome of = {.placed = placed};
    double started = progress_clock();
    if (asked.certificate && !certificate_hash(asked.scene, stderr, &of.hash))
        return EXIT_USAGE;
    if (!render_file_draw(asked.scene, placed, &asked.settings, stderr, &of.drawn))
        return EXIT_USAGE;
    int status = draw_heat(&of) ? write_all(&of) : EXIT_OUTPUT;
    if (status == 0)
        print_words(&of, progress_clock() - started + placed->read + placed->place);
    picture_free(&of.heat);
    rendering_free(&of.drawn);
    return status;
}

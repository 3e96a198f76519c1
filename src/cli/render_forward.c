#include "render_forward.h"

#include "photons.h"

#include "../evidence/certificate.h"
#include "../evidence/explain.h"
#include "../support/progress.h"
#include "../photons/render_forward.h"
#include "../scene/rt_notes.h"
#include "../photons/partial_film.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#define PHOTONS_DEFAULT 10000000
#define BOUNCES_DEFAULT 16

typedef struct {
    const args *line;
    const render_request *asked;
    const placed_scene *placed;
    photon_range wanted;
    share sum;       /* of what was continued and what was traced */
    uint64_t traced; /* photons */
    bool interrupted;
    render_times times;
    double write; /* seconds */
} work;

/* Settings. */

/* Light that does not fall off has no energy to be spread by further bounces. */
static int settle_bounces(const work *w, int *bounces)
{
    char option[32];
    bool falls = w->placed->options.falloff == SURE_FALLOFF_INVERSE_SQUARE;
    *bounces = w->asked->forward.bounces;
    if (*bounces == 0)
        *bounces = falls ? BOUNCES_DEFAULT : 1;
    if (falls || *bounces == 1)
        return 0;
    snprintf(option, sizeof option, "--bounces %d", *bounces);
    return render_clash(w->line, option, "--falloff none",
                        "light goes on only where it falls off: add --falloff inverse-square");
}

static void settle_range(work *w)
{
    uint64_t photons = w->asked->settings.how.photons, first = w->asked->forward.first;
    if (photons == 0) {
        photons = PHOTONS_DEFAULT;
        if (photons > SHARE_PHOTONS_MOST - first)
            photons = SHARE_PHOTONS_MOST - first;
    }
    w->wanted = (photon_range){first, first + photons};
}

static int complain(const char *path, const char *what, int status)
{
    fprintf(stderr, "%s: error: %s\n", path, what);
    return status;
}

/* A share without photons. */
static int begin(work *w)
{
    const render_request *asked = w->asked;
    share *sum = &w->sum;
    if ((asked->forward.share || asked->forward.from) &&
        !certificate_hash(asked->scene, stderr, &sum->hash))
        return EXIT_USAGE;
    if (!render_forward_possible(&w->placed->scene))
        return complain(asked->scene, "no light that photons could leave", EXIT_USAGE);
    sum->options = w->placed->options;
    sum->tier = asked->settings.how.tier;
    sum->how.seed = asked->settings.how.seed;
    sum->how.aperture = asked->forward.aperture;
    sum->scene = rt_printable_name(asked->scene);
    if (!sum->scene || !film_new(sum->options.width, sum->options.height, &sum->sums))
        return complain(asked->scene, "no memory for this picture", EXIT_USAGE);
    settle_range(w);
    return settle_bounces(w, &sum->how.bounces);
}

/* What was done before. */

static int check_continued(const work *w, const share *before)
{
    const char *path = w->asked->forward.from, *other = share_difference(before, &w->sum);
    if (other) {
        fprintf(stderr, "%s: error: can't be continued here: it has another %s\n", path, other);
        return EXIT_USAGE;
    }
    for (size_t i = 0; i < before->range_count; i++) {
        const photon_range *there = &before->ranges[i];
        if (there->first >= w->wanted.first && there->end <= w->wanted.end)
            continue;
        fprintf(stderr,
                "%s: error: has photons %" PRIu64 " to %" PRIu64
                ", which are not all among those of --first and --photons, %" PRIu64 " to %" PRIu64
                "\n",
                path, there->first, there->end - 1, w->wanted.first, w->wanted.end - 1);
        return EXIT_USAGE;
    }
    return 0;
}

static int take_continued(work *w)
{
    share before;
    if (!w->asked->forward.from)
        return 0;
    if (!share_read(w->asked->forward.from, stderr, &before))
        return EXIT_USAGE;
    int status = check_continued(w, &before);
    if (status == 0 && !share_add(&w->sum, &before))
        status = complain(w->asked->forward.from, "no memory", EXIT_USAGE);
    share_free(&before);
    return status;
}

/* What is done here. */

static bool trace_gap(work *w, photon_range gap)
{
    const render_options *how = &w->asked->settings.how;
    const forward_run run = {
        .tier = how->tier,
        .threads = how->threads,
        .progress = how->progress,
        .without_bvh = how->without_bvh,
        .how = w->sum.how,
        .first = gap.first,
        .end = gap.end,
    };
    forward_outcome done = render_forward(&w->placed->scene, &run, &w->sum.sums, &w->sum.account);
    w->times.build += done.times.build;
    w->times.frame += done.times.frame;
    w->traced += done.end - gap.first;
    w->interrupted = done.end < gap.end;
    return share_add_range(&w->sum, (photon_range){gap.first, done.end});
}

static int trace(work *w)
{
    photon_range gap;
    while (!w->interrupted && share_gap(&w->sum, w->wanted, &gap)) {
        if (!trace_gap(w, gap))
            return complain(w->asked->scene, "no memory", EXIT_OUTPUT);
    }
    return 0;
}

static int write_picture(const work *w)
{
    picture image;
    if (!picture_new(w->sum.sums.width, w->sum.sums.height, &image))
        return complain(w->asked->scene, "no memory for this picture", EXIT_OUTPUT);
    film_picture(&w->sum.sums, w->sum.account.emitted, &image);
    int status = render_write_pictures(w->asked, &image);
    picture_free(&image);
    return status;
}

/* The share first: it can be drawn again, the picture cannot be added to. */
static int write_all(work *w)
{
    const char *path = w->asked->forward.share;
    double started = progress_clock();
    bool written = !path || share_write(&w->sum, path, stderr);
    int status = write_picture(w);
    w->write = progress_clock() - started;
    return written ? status : EXIT_OUTPUT;
}

/* Words about it. */

/* What all photons take, by those of this run. */
static double seconds_of_all(const work *w)
{
    if (w->traced == 0)
        return PHOTONS_UNTIMED;
    return w->times.frame * ((double)w->sum.account.emitted / (double)w->traced);
}

static void print_summary(const work *w, double seconds)
{
    const render_request *asked = w->asked;
    for (int i = 0; i < asked->output_count; i++)
        printf("%s%s", i > 0 ? ", " : "", asked->outputs[i]);
    if (asked->forward.share)
        printf(", %s", asked->forward.share);
    printf(": %dx%d, %.2f s\n", w->sum.sums.width, w->sum.sums.height, seconds);
    photons_print(stdout, &w->sum, seconds_of_all(w));
}

static void print_features(const work *w)
{
    const render_options *how = &w->asked->settings.how;
    scene_features features = scene_features_of(&w->placed->scene, how);
    explain_features(stdout, &features, how);
}

static void print_times(const work *w)
{
    printf("{\"read\": %.6f, \"place\": %.6f, \"build\": %.6f, \"frame\": %.6f, \"write\": %.6f, "
           "\"objects\": %zu, \"threads\": %d",
           w->placed->read, w->placed->place, w->times.build, w->times.frame, w->write,
           w->placed->scene.object_count, render_threads(&w->asked->settings.how));
    photons_print_json(stdout, &w->sum, seconds_of_all(w));
    puts("}");
}

static void print_interrupted(const work *w)
{
    const char *path = w->asked->forward.share;
    fprintf(stderr, "%s: interrupted after %" PRIu64 " photons (", w->line->command,
            w->sum.account.emitted);
    photons_print_ranges(stderr, &w->sum);
    if (path)
        fprintf(stderr, "); go on with the same words and --continue %s\n", path);
    else
        fputs("); to be able to go on, give --share FILE\n", stderr);
}

static int finish(work *w)
{
    double started = progress_clock();
    int status = trace(w);
    if (status == 0)
        status = write_all(w);
    if (status != 0)
        return status;
    if (!w->asked->quiet)
        print_summary(w, progress_clock() - started + w->placed->read + w->placed->place);
    if (w->asked->explain)
        print_features(w);
    if (w->asked->time)
        print_times(w);
    if (w->interrupted)
        print_interrupted(w);
    return w->interrupted ? EXIT_INTERRUPTED : 0;
}

int render_forward_placed(const args *line, const render_request *asked, const placed_scene *placed)
{
    work w = {.line = line, .asked = asked, .placed = placed};
    int status = begin(&w);
    if (status == 0)
        status = take_continued(&w);
    if (status == 0)
        status = finish(&w);
    share_free(&w.sum);
    return status;
}

/* SPDX-License-Identifier: MIT */
#include "forward_sum.h"

#include "../hierarchy/bvh_build.h"
#include "../support/complain.h"
#include "../support/openmp.h"
#include "../support/progress.h"
#include "photon.h"

#include <inttypes.h>
#include <math.h>
#include <signal.h>

index_range forward_sum_range(const forward_plan *plan)
{
    uint64_t photons = plan->settings->photons, left = RANGES_MOST - plan->first;
    if (photons == 0)
        photons = FORWARD_PHOTONS < left ? FORWARD_PHOTONS : left;
    return (index_range){plan->first, plan->first + photons};
}

static bool check_continued(const forward_plan *plan, FILE *messages, const partial_film *before,
                            const partial_film *like)
{
    const char *other = partial_film_difference(before, like);
    index_range wanted = forward_sum_range(plan);
    if (other)
        return complain(messages, plan->from, "can't be continued here: it has another %s", other);
    for (size_t i = 0; i < before->ranges.count; i++) {
        const index_range *there = &before->ranges.of[i];
        if (there->first < wanted.first || there->end > wanted.end)
            return complain(messages, plan->from,
                            "has photons %" PRIu64 " to %" PRIu64
                            ", which are not all among those of --first and --photons, %" PRIu64
                            " to %" PRIu64,
                            there->first, there->end - 1, wanted.first, wanted.end - 1);
    }
    return true;
}

/* A film without photons, or the one that is continued. */
static bool begin(const forward_plan *plan, FILE *messages, partial_film *sum)
{
    const partial_film like = {.options = plan->placed->options,
                               .hash = plan->placed->hash,
                               .tier = plan->settings->how.tier,
                               .how = plan->how};
    if (!(total_power(&plan->placed->scene) > 0))
        return complain(messages, plan->scene, "no light that photons could leave");
    if (plan->from)
        return partial_film_read(plan->from, messages, sum) &&
               check_continued(plan, messages, sum, &like);
    return partial_film_begin(&like, sum) ||
           complain(messages, plan->scene, "no memory for this picture");
}

static volatile sig_atomic_t interrupted;
static struct sigaction before; /* what a SIGINT did */

static void note(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

/* From here on a first SIGINT is noted, a second one does what it did before. Where somebody else
 * has decided what it does, as where it is ignored, that stays. */
static void catch_interrupt(void)
{
    struct sigaction noting = {.sa_handler = note, .sa_flags = (int)(SA_RESETHAND | SA_RESTART)};
    interrupted = 0;
    sigaction(SIGINT, NULL, &before);
    if (before.sa_handler == SIG_DFL)
        sigaction(SIGINT, &noting, NULL);
}

/* Photons that a thread takes at a time, in order: so those that were traced are always the first
 * ones, and some milliseconds after an interrupt all threads are back. */
#define RUN 4096

/* Light at the eye that a thread keeps to itself before it waits for the film. */
#define KEPT_MOST 128

/* The estimate of the error reads all of the film: at most this share of the time goes into it. */
#define ESTIMATE_SHARE 0.02

/* Photons while they are traced. */
typedef struct {
    const sure_scene *scene;
    partial_film *sum;
    index_range left; /* that no thread has taken yet */
    bool begun;
    bool (*is_due)(void);
    progress bar;
    double estimate_due; /* when */
} drawing;

typedef struct {
    int column, row;
    sure_vec3 value;
} splat;

/* What a thread has gathered. */
typedef struct {
    drawing *of;
    sure_forward_statistics statistics;
    int count;
    splat kept[KEPT_MOST];
} gathered;

/* Empty: there are none left, or no more are wanted. */
static index_range take_run(drawing *d)
{
    index_range taken;
    OPENMP(omp critical(forward_take))
    {
        bool stop = d->begun && (interrupted || (d->is_due && d->is_due()));
        uint64_t more = d->left.end - d->left.first < RUN ? d->left.end - d->left.first : RUN;
        taken = (index_range){d->left.first, d->left.first + (stop ? 0 : more)};
        d->left.first = taken.end;
        d->begun = true;
    }
    return taken;
}

static void put_on_film(gathered *g)
{
    OPENMP(omp critical(forward_film))
    for (int i = 0; i < g->count; i++)
        film_add(&g->of->sum->sums, g->kept[i].column, g->kept[i].row, g->kept[i].value);
    g->count = 0;
}

static void keep(void *to, int column, int row, sure_vec3 value)
{
    gathered *g = to;
    if (g->count == KEPT_MOST)
        put_on_film(g);
    g->kept[g->count++] = (splat){column, row, value};
}

/* The error of a pixel's value, as a share of the mean one. */
static void estimate(drawing *d)
{
    double started = progress_clock();
    if (started < d->estimate_due)
        return;
    const film *sums = &d->sum->sums;
    uint64_t photons = d->sum->statistics.emitted;
    double error = sqrt(film_variance(sums, photons)) / film_mean(sums, photons);
    double now = progress_clock();
    d->estimate_due = now + (now - started) / ESTIMATE_SHARE;
    if (isfinite(error))
        snprintf(d->bar.note, sizeof d->bar.note, "error %.3g %%", 100 * error);
}

static void finish_run(gathered *g, uint64_t photons)
{
    drawing *d = g->of;
    put_on_film(g);
    OPENMP(omp critical(forward_film))
    {
        sure_forward_statistics_add(&d->sum->statistics, &g->statistics);
        if (progress_is_due(&d->bar))
            estimate(d);
        progress_step(&d->bar, (int64_t)photons);
    }
    g->statistics = (sure_forward_statistics){0};
}

static void trace_runs(drawing *d)
{
    gathered g = {.of = d};
    for (index_range run = take_run(d); run.first < run.end; run = take_run(d)) {
        for (uint64_t i = run.first; i < run.end; i++)
            sure_forward_photon(d->scene, d->sum->tier, &d->sum->how, i, keep, &g, &g.statistics);
        finish_run(&g, run.end - run.first);
    }
}

bool forward_sum_trace(const sure_scene *scene, const render_options *options, index_range photons,
                       forward_sum *to)
{
    double started = progress_clock();
    sure_scene indexed = *scene;
    sure_bvh bvh;
    sure_float_object *floats = placement_floats(scene, options->tier);
    indexed.floats = floats;
    indexed.bvh = bvh_for(scene, !options->without_bvh, options->threads, &bvh);
    double ready = progress_clock();
    drawing d = {.scene = &indexed, .sum = &to->sum, .left = photons, .is_due = options->is_due};
    d.bar =
        progress_start(options->progress ? stderr : NULL, (int64_t)(photons.end - photons.first));
    catch_interrupt();
    OPENMP(omp parallel num_threads(openmp_threads(options->threads)))
    trace_runs(&d);
    sigaction(SIGINT, &before, NULL);
    progress_finish(&d.bar);
    bvh_free(&bvh);
    free(floats);
    to->times.build += ready - started;
    to->times.frame += progress_clock() - ready;
    to->times.bytes = indexed.bvh ? bvh_bytes(&bvh, scene->object_count) : 0;
    to->traced += d.left.first - photons.first;
    to->interrupted = d.left.first < photons.end;
    return ranges_add(&to->sum.ranges, (index_range){photons.first, d.left.first});
}

bool forward_sum_begin(const forward_plan *plan, FILE *messages, forward_sum *done)
{
    *done = (forward_sum){.traced = 0};
    return begin(plan, messages, &done->sum);
}

bool forward_sum_fill(const forward_plan *plan, FILE *messages, forward_sum *done)
{
    index_range gap;
    while (!done->interrupted && ranges_gap(&done->sum.ranges, forward_sum_range(plan), &gap)) {
        if (!forward_sum_trace(&plan->placed->scene, &plan->settings->how, gap, done))
            return complain(messages, plan->scene, "no memory");
    }
    return true;
}

double forward_sum_seconds(const forward_sum *of)
{
    if (of->traced == 0)
        return PHOTONS_UNTIMED;
    return of->times.frame * ((double)of->sum.statistics.emitted / (double)of->traced);
}

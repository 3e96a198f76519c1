#include "render_forward.h"

#include "../hierarchy/bvh_build.h"
#include "../support/interrupt.h"
#include "../support/openmp.h"
#include "../support/progress.h"
#include "power.h"

#include <math.h>

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
    const forward_run *asked;
    film *sums;
    sure_forward_statistics *statistics;
    uint64_t next; /* the first photon that no thread has taken yet */
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

bool render_forward_possible(const sure_scene *scene)
{
    return total_power(scene) > 0;
}

/* False: there are none left, or no more are wanted. */
static bool take_run(drawing *d, uint64_t *first, uint64_t *end)
{
    bool taken;
    OPENMP(omp critical(forward_take))
    {
        bool stop = d->next > d->asked->first && interrupt_caught();
        taken = !stop && d->next < d->asked->end;
        if (taken) {
            *first = d->next;
            *end = d->asked->end - d->next < RUN ? d->asked->end : d->next + RUN;
            d->next = *end;
        }
    }
    return taken;
}

static void put_on_film(gathered *g)
{
    OPENMP(omp critical(forward_film))
    for (int i = 0; i < g->count; i++)
        film_add(g->of->sums, g->kept[i].column, g->kept[i].row, g->kept[i].value);
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
    char text[PROGRESS_NOTE];
    double started = progress_clock();
    if (started < d->estimate_due)
        return;
    double error = sqrt(film_variance(d->sums, d->statistics->emitted)) /
                   film_mean(d->sums, d->statistics->emitted);
    double now = progress_clock();
    d->estimate_due = now + (now - started) / ESTIMATE_SHARE;
    if (!isfinite(error))
        return;
    snprintf(text, sizeof text, "error %.3g %%", 100 * error);
    progress_note(&d->bar, text);
}

static void finish_run(gathered *g, uint64_t photons)
{
    drawing *d = g->of;
    put_on_film(g);
    OPENMP(omp critical(forward_film))
    {
        sure_forward_statistics_add(d->statistics, &g->statistics);
        if (d->asked->progress) {
            if (progress_is_due(&d->bar))
                estimate(d);
            progress_step(&d->bar, (int64_t)photons);
        }
    }
    g->statistics = (sure_forward_statistics){0};
}

static void trace_runs(drawing *d)
{
    gathered g = {.of = d};
    uint64_t first, end;
    while (take_run(d, &first, &end)) {
        for (uint64_t i = first; i < end; i++)
            sure_forward_photon(d->scene, d->asked->tier, &d->asked->how, i, keep, &g,
                                &g.statistics);
        finish_run(&g, end - first);
    }
}

forward_outcome render_forward(const sure_scene *scene, const forward_run *run, film *sums,
                               sure_forward_statistics *statistics)
{
    double started = progress_clock();
    sure_scene indexed = *scene;
    sure_bvh bvh;
    bool built = !run->without_bvh &&
                 bvh_build_worthwhile(scene->objects, scene->object_count, run->threads, &bvh);
    double ready = progress_clock();
    indexed.bvh = built ? &bvh : NULL;
    drawing d = {.scene = &indexed, .asked = run, .sums = sums, .statistics = statistics};
    d.next = run->first;
    d.bar = progress_start(stderr, (int64_t)(run->end - run->first));
    interrupt_catch();
    OPENMP(omp parallel num_threads(openmp_threads(run->threads)))
    trace_runs(&d);
    interrupt_release();
    progress_finish(&d.bar);
    if (built)
        bvh_free(&bvh);
    return (forward_outcome){d.next, {.build = ready - started, .frame = progress_clock() - ready}};
}

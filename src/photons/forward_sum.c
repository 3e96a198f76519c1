#include "forward_sum.h"

#include "photon_counts.h"
#include "render_forward.h"

#include <inttypes.h>

static forward_status complain(FILE *messages, const char *path, const char *what,
                               forward_status status)
{
    fprintf(messages, "%s: error: %s\n", path, what);
    return status;
}

static photon_range range_of(const forward_plan *plan)
{
    uint64_t photons = plan->settings->photons, left = PHOTONS_MOST - plan->first;
    if (photons == 0)
        photons = FORWARD_PHOTONS < left ? FORWARD_PHOTONS : left;
    return (photon_range){plan->first, plan->first + photons};
}

/* A film without photons. */
static forward_status begin(const forward_plan *plan, FILE *messages, partial_film *sum)
{
    if (!render_forward_possible(&plan->placed->scene))
        return complain(messages, plan->scene, "no light that photons could leave", FORWARD_UNFIT);
    const partial_film like = {.options = plan->placed->options,
                               .hash = plan->hash,
                               .tier = plan->settings->how.tier,
                               .how = plan->how};
    if (!partial_film_begin(&like, sum))
        return complain(messages, plan->scene, "no memory for this picture", FORWARD_UNFIT);
    return FORWARD_TRACED;
}

/* What was done before. */

static bool check_continued(const forward_plan *plan, FILE *messages, const partial_film *before,
                            const partial_film *sum)
{
    const char *other = partial_film_difference(before, sum);
    photon_range wanted = range_of(plan);
    if (other) {
        fprintf(messages, "%s: error: can't be continued here: it has another %s\n", plan->from,
                other);
        return false;
    }
    for (size_t i = 0; i < before->range_count; i++) {
        const photon_range *there = &before->ranges[i];
        if (there->first >= wanted.first && there->end <= wanted.end)
            continue;
        fprintf(messages,
                "%s: error: has photons %" PRIu64 " to %" PRIu64
                ", which are not all among those of --first and --photons, %" PRIu64 " to %" PRIu64
                "\n",
                plan->from, there->first, there->end - 1, wanted.first, wanted.end - 1);
        return false;
    }
    return true;
}

static forward_status take_continued(const forward_plan *plan, FILE *messages, partial_film *sum)
{
    partial_film before;
    if (!plan->from)
        return FORWARD_TRACED;
    if (!partial_film_read(plan->from, messages, &before))
        return FORWARD_UNFIT;
    forward_status status =
        check_continued(plan, messages, &before, sum) ? FORWARD_TRACED : FORWARD_UNFIT;
    if (status == FORWARD_TRACED && !partial_film_add(sum, &before))
        status = complain(messages, plan->from, "no memory", FORWARD_UNFIT);
    partial_film_free(&before);
    return status;
}

/* What is done here. */

static bool trace_gap(const forward_plan *plan, photon_range gap, forward_sum *done)
{
    forward_outcome traced =
        render_forward(&plan->placed->scene, &plan->settings->how, gap, &done->sum);
    done->times.build += traced.times.build;
    done->times.frame += traced.times.frame;
    done->traced += traced.end - gap.first;
    done->interrupted = traced.end < gap.end;
    return partial_film_add_range(&done->sum, (photon_range){gap.first, traced.end});
}

forward_status forward_sum_of(const forward_plan *plan, FILE *messages, forward_sum *done)
{
    photon_range gap;
    *done = (forward_sum){.traced = 0};
    forward_status status = begin(plan, messages, &done->sum);
    if (status == FORWARD_TRACED)
        status = take_continued(plan, messages, &done->sum);
    while (status == FORWARD_TRACED && !done->interrupted &&
           partial_film_gap(&done->sum, range_of(plan), &gap)) {
        if (!trace_gap(plan, gap, done))
            status = complain(messages, plan->scene, "no memory", FORWARD_NO_MEMORY);
    }
    return status;
}

double forward_sum_seconds(const forward_sum *of)
{
    if (of->traced == 0)
        return PHOTONS_UNTIMED;
    return of->times.frame * ((double)of->sum.statistics.emitted / (double)of->traced);
}

/* SPDX-License-Identifier: MIT */
/* Shares of one scene's photons added up. */
#include "../support/complain.h"
#include "../support/progress.h"
#include "partial_film.h"

#include <inttypes.h>
#include <stdlib.h>

/* Shares without their sums, as many as were read; the sum of those that were added. */
typedef struct {
    const char *const *paths;
    FILE *messages;
    partial_film *added;
    int count;
    partial_film *sum;
} merging;

static bool fits(const merging *m, const partial_film *next)
{
    const char *path = m->paths[m->count];
    const char *other = m->count > 0 ? partial_film_difference(m->sum, next) : NULL;
    index_range both;
    if (other)
        return complain(m->messages, path, "can't be added to %s: it has another %s", m->paths[0],
                        other);
    for (int i = 0; i < m->count; i++) {
        if (ranges_overlap(&m->added[i].ranges, &next->ranges, &both))
            return complain(m->messages, path, "photons %" PRIu64 " to %" PRIu64 " are in %s, too",
                            both.first, both.end - 1, m->paths[i]);
    }
    return true;
}

static bool add_file(merging *m)
{
    const char *path = m->paths[m->count];
    partial_film next;
    if (!partial_film_read(path, m->messages, &next))
        return false;
    bool fitting = fits(m, &next), first = m->count == 0;
    bool added =
        fitting && (!first || partial_film_begin(&next, m->sum)) && partial_film_add(m->sum, &next);
    if (fitting && !added)
        complain(m->messages, path, "no memory");
    film_free(&next.sums);
    m->added[m->count++] = next;
    return added;
}

bool merge_partial_films(const char *const *paths, int count, FILE *messages, partial_film *sum)
{
    merging m = {paths, messages, calloc((size_t)count, sizeof *m.added), 0, sum};
    bool done = m.added || complain(messages, paths[0], "no memory");
    *sum = (partial_film){0};
    progress bar = progress_start(messages, count);
    while (done && m.count < count) {
        done = add_file(&m);
        progress_step(&bar, done);
    }
    progress_finish(&bar);
    for (int i = 0; i < m.count; i++)
        partial_film_free(&m.added[i]);
    free(m.added);
    return done;
}

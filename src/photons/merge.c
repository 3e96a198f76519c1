/* Shares of one scene's photons added up. */
#include "partial_film.h"

#include <inttypes.h>
#include <stdlib.h>

/* Shares without their sums, as many as were added; the sum of all. */
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
    for (int i = 0; i < m->count; i++) {
        const char *other = partial_film_difference(&m->added[i], next);
        photon_range both;
        if (other) {
            fprintf(m->messages, "%s: error: can't be added to %s: it has another %s\n", path,
                    m->paths[i], other);
            return false;
        }
        if (partial_film_overlap(&m->added[i], next, &both)) {
            fprintf(m->messages, "%s: error: photons %" PRIu64 " to %" PRIu64 " are in %s, too\n",
                    path, both.first, both.end - 1, m->paths[i]);
            return false;
        }
    }
    return true;
}

static bool add(merging *m, partial_film *next)
{
    bool added =
        (m->count > 0 || partial_film_begin(next, m->sum)) && partial_film_add(m->sum, next);
    if (!added)
        fprintf(m->messages, "%s: error: no memory\n", m->paths[m->count]);
    film_free(&next->sums);
    m->added[m->count++] = *next;
    return added;
}

static bool add_file(merging *m)
{
    partial_film next;
    if (!partial_film_read(m->paths[m->count], m->messages, &next))
        return false;
    if (fits(m, &next))
        return add(m, &next);
    partial_film_free(&next);
    return false;
}

bool merge_partial_films(const char *const *paths, int count, FILE *messages, partial_film *sum)
{
    merging m = {paths, messages, calloc((size_t)count, sizeof *m.added), 0, sum};
    bool done = m.added != NULL;
    *sum = (partial_film){0};
    if (!done)
        fprintf(messages, "%s: error: no memory\n", paths[0]);
    while (done && m.count < count)
        done = add_file(&m);
    for (int i = 0; i < m.count; i++)
        partial_film_free(&m.added[i]);
    free(m.added);
    return done;
}

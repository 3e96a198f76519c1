/* SPDX-License-Identifier: MIT */
#include "photons.h"

#include "../../support/base64.h"
#include "../../support/complain.h"
#include "../../support/pieces/cut.h"

#include <stdlib.h>
#include <unistd.h>

typedef struct {
    const forward_plan *plan;
    render_options how;
    index_range all; /* photons; a piece counts from the first one */
    forward_sum *done;
} photons;

/* In runs that end when what is done is to be kept. */
static bool work(void *sum, index_range some)
{
    const photons *of = sum;
    const char *scene = of->plan->scene;
    while (some.first < some.end) {
        const index_range left = {of->all.first + some.first, of->all.first + some.end};
        uint64_t before = of->done->traced;
        if (!forward_sum_trace(&of->plan->placed->scene, &of->how, left, of->done))
            return complain(stderr, scene, "no memory");
        some.first += of->done->traced - before;
        if (of->done->interrupted && !cut_is_due())
            return complain(stderr, scene, "interrupted");
        if (!cut_goes_on(some.first))
            return false;
    }
    return true;
}

/* All of a file, as text. */
static char *text_of(FILE *file)
{
    long size = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    char *bytes = size > 0 ? malloc((size_t)size) : NULL;
    rewind(file);
    bool read = bytes && fread(bytes, 1, (size_t)size, file) == (size_t)size;
    char *text = read ? base64_of(bytes, (size_t)size) : NULL;
    free(bytes);
    return text;
}

static json_t *tell(const void *sum, const index_ranges *done)
{
    const photons *of = sum;
    FILE *file = tmpfile();
    bool put = file && partial_film_put(&of->done->sum, dup(fileno(file)));
    char *text = put ? text_of(file) : NULL;
    json_t *said = text ? json_pack("{s:s}", "share", text) : NULL;
    (void)done; /* all that is in the sum */
    free(text);
    if (file)
        fclose(file);
    return said;
}

static const char *take_share(const json_t *from, partial_film *read)
{
    size_t size;
    const char *wrong = "expected a share";
    FILE *file = tmpfile();
    uint8_t *bytes = base64_bytes(json_string_value(from), &size);
    *read = (partial_film){0};
    if (file && bytes && fwrite(bytes, 1, size, file) == size && fflush(file) == 0) {
        rewind(file);
        wrong = partial_film_get(dup(fileno(file)), read);
    }
    free(bytes);
    if (file)
        fclose(file);
    return wrong;
}

/* Are they these photons? */
static bool is_of(const photons *of, const index_ranges *done, const partial_film *share)
{
    bool same = done->count == share->ranges.count;
    for (size_t i = 0; same && i < done->count; i++)
        same = of->all.first + done->of[i].first == share->ranges.of[i].first &&
               of->all.first + done->of[i].end == share->ranges.of[i].end;
    return same && !partial_film_difference(&of->done->sum, share);
}

static const char *add(void *sum, const index_ranges *done, const json_t *told)
{
    const photons *of = sum;
    partial_film share;
    const char *wrong = take_share(json_object_get(told, "share"), &share);
    if (!wrong && !is_of(of, done, &share))
        wrong = "its share is of others";
    if (!wrong && !partial_film_add(&of->done->sum, &share))
        wrong = "no memory";
    partial_film_free(&share);
    return wrong;
}

int photons_do(const forward_plan *plan, forward_sum *done)
{
    photons of = {plan, plan->settings->how, forward_sum_range(plan), done};
    of.how.is_due = cut_is_due;
    if (of.how.threads == 0)
        of.how.threads = 1; /* there are pieces for all cores */
    return cut_do(&(cut_work){.unit = "photons",
                              .total = of.all.end - of.all.first,
                              .input = {plan->scene, plan->placed->hash},
                              .sum = &of,
                              .work = work,
                              .tell = tell,
                              .add = add});
}

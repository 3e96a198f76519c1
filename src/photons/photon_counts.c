#include "photon_counts.h"

#include "../support/json_file.h"

#include <inttypes.h>
#include <math.h>

/* As they stand in sure_forward_statistics. */
static const struct {
    const char *name, *words;
} counts[] = {
    {"photons", "photons left"},          {"escaped", "  escaped"},
    {"absorbed", "  absorbed"},           {"stopped", "  stopped"},
    {"entered", "  entered the opening"}, {"lit", "points lit"},
    {"through", "passed the view plane"}, {"reached", "reached the eye"},
};

#define COUNTS (sizeof counts / sizeof *counts)
_Static_assert(sizeof(sure_forward_statistics) == COUNTS * sizeof(uint64_t), "a row a count");

void photons_print(FILE *out, const partial_film *of, double seconds)
{
    const uint64_t photons = of->statistics.emitted;
    double variance = film_variance(&of->sums, photons);
    for (size_t i = 0; i < COUNTS; i++) {
        uint64_t count = (&of->statistics.emitted)[i];
        fprintf(out, "%-22s %12" PRIu64, counts[i].words, count);
        if (i > 0)
            fprintf(out, " %12.1f per million", 1e6 * (double)count / (double)photons);
        fputc('\n', out);
    }
    fprintf(out, "variance of a pixel's mean %.4g", variance);
    if (seconds >= 0)
        fprintf(out, ", times %.2f s: %.4g s", seconds, variance * seconds);
    fputc('\n', out);
}

json_t *photon_counts_json(const sure_forward_statistics *sum)
{
    json_t *object = json_object();
    for (size_t i = 0; i < COUNTS; i++)
        json_object_set_new(object, counts[i].name, json_integer((json_int_t)(&sum->emitted)[i]));
    return object;
}

bool photon_counts_from_json(const json_t *object, sure_forward_statistics *sum)
{
    for (size_t i = 0; i < COUNTS; i++) {
        if (!json_take_count(json_object_get(object, counts[i].name), &sum->emitted + i))
            return false;
    }
    return json_object_size(object) == COUNTS;
}

json_t *photons_json(const partial_film *of, double seconds)
{
    double variance = film_variance(&of->sums, of->statistics.emitted);
    json_t *object = photon_counts_json(&of->statistics);
    json_object_set_new(object, "variance", json_measured(variance));
    json_object_set_new(object, "variance_seconds",
                        json_measured(seconds >= 0 ? variance * seconds : INFINITY));
    return object;
}

void photons_print_ranges(FILE *out, const partial_film *of)
{
    for (size_t i = 0; i < of->range_count; i++)
        fprintf(out, "%s%" PRIu64 " to %" PRIu64, i > 0 ? ", " : "", of->ranges[i].first,
                of->ranges[i].end - 1);
}

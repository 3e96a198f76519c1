#include "photon_counts.h"

#include "../support/json_file.h"

#include <inttypes.h>
#include <math.h>

static void print_count(FILE *out, const char *what, uint64_t count, uint64_t photons)
{
    fprintf(out, "%-22s %12" PRIu64 " %12.1f per million\n", what, count,
            1e6 * (double)count / (double)photons);
}

void photons_print(FILE *out, const partial_film *of, double seconds)
{
    const sure_forward_statistics *sum = &of->statistics;
    const struct {
        const char *what;
        uint64_t count;
    } lines[] = {
        {"  escaped", sum->escaped},       {"  absorbed", sum->absorbed},
        {"  stopped", sum->stopped},       {"  entered the opening", sum->entered},
        {"points lit", sum->lit},          {"passed the view plane", sum->through},
        {"reached the eye", sum->reached},
    };
    double variance = film_variance(&of->sums, sum->emitted);
    fprintf(out, "%-22s %12" PRIu64 "\n", "photons left", sum->emitted);
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        print_count(out, lines[i].what, lines[i].count, sum->emitted);
    fprintf(out, "variance of a pixel's mean %.4g", variance);
    if (seconds >= 0)
        fprintf(out, ", times %.2f s: %.4g s", seconds, variance * seconds);
    fputc('\n', out);
}

json_t *photons_json(const partial_film *of, double seconds)
{
    const sure_forward_statistics *sum = &of->statistics;
    double variance = film_variance(&of->sums, sum->emitted);
    return json_pack("{s:I, s:I, s:I, s:I, s:I, s:I, s:I, s:I, s:o, s:o}", "photons",
                     (json_int_t)sum->emitted, "escaped", (json_int_t)sum->escaped, "absorbed",
                     (json_int_t)sum->absorbed, "stopped", (json_int_t)sum->stopped, "entered",
                     (json_int_t)sum->entered, "lit", (json_int_t)sum->lit, "through",
                     (json_int_t)sum->through, "reached", (json_int_t)sum->reached, "variance",
                     json_measured(variance), "variance_seconds",
                     json_measured(seconds >= 0 ? variance * seconds : INFINITY));
}

void photons_print_ranges(FILE *out, const partial_film *of)
{
    for (size_t i = 0; i < of->range_count; i++)
        fprintf(out, "%s%" PRIu64 " to %" PRIu64, i > 0 ? ", " : "", of->ranges[i].first,
                of->ranges[i].end - 1);
}

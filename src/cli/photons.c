#include "photons.h"

#include <inttypes.h>
#include <math.h>

static void print_count(FILE *out, const char *what, uint64_t count, uint64_t photons)
{
    fprintf(out, "%-22s %12" PRIu64 " %12.1f per million\n", what, count,
            1e6 * (double)count / (double)photons);
}

void photons_print(FILE *out, const share *of, double seconds)
{
    const sure_forward_account *sum = &of->account;
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

/* JSON knows no infinity. */
static void print_number(FILE *out, const char *name, double value)
{
    if (isfinite(value))
        fprintf(out, ", \"%s\": %.9g", name, value);
    else
        fprintf(out, ", \"%s\": null", name);
}

void photons_print_json(FILE *out, const share *of, double seconds)
{
    const sure_forward_account *sum = &of->account;
    double variance = film_variance(&of->sums, sum->emitted);
    fprintf(out, ", \"photons\": %" PRIu64 ", \"escaped\": %" PRIu64 ", \"absorbed\": %" PRIu64,
            sum->emitted, sum->escaped, sum->absorbed);
    fprintf(out, ", \"stopped\": %" PRIu64 ", \"entered\": %" PRIu64 ", \"lit\": %" PRIu64,
            sum->stopped, sum->entered, sum->lit);
    fprintf(out, ", \"through\": %" PRIu64 ", \"reached\": %" PRIu64, sum->through, sum->reached);
    print_number(out, "variance", variance);
    print_number(out, "variance_seconds", seconds >= 0 ? variance * seconds : INFINITY);
}

void photons_print_ranges(FILE *out, const share *of)
{
    for (size_t i = 0; i < of->range_count; i++)
        fprintf(out, "%s%" PRIu64 " to %" PRIu64, i > 0 ? ", " : "", of->ranges[i].first,
                of->ranges[i].end - 1);
}

#include "tally.h"

#include <math.h>
#include <string.h>

/* The normal law has 95 % within this many standard deviations. */
#define DEVIATIONS 1.959963984540054

/* The two p at which the counted share k/n is DEVIATIONS of sqrt(p (1 - p) / n) away from p: the
 * roots of a quadratic. */
confidence confidence_of(uint64_t counted, uint64_t sample)
{
    if (sample == 0)
        return (confidence){0, 1};
    double n = (double)sample, k = (double)counted, square = DEVIATIONS * DEVIATIONS;
    double middle = k + square / 2;
    double spread = DEVIATIONS * sqrt(k * (n - k) / n + square / 4);
    double whole = n + square;
    return (confidence){counted == 0 ? 0 : (middle - spread) / whole,
                        counted == sample ? 1 : (middle + spread) / whole};
}

#define SHIFT 47 /* sign, eleven bits of exponent and five of the mantissa are left: below 2^16 */

void histogram_add(histogram *all, double size)
{
    uint64_t bits;
    if (isnan(size))
        size = INFINITY;
    memcpy(&bits, &size, sizeof bits);
    all->bins[bits >> SHIFT]++;
    all->count++;
    all->zeros += size == 0;
    if (size > all->most)
        all->most = size;
}

/* The least number above all of the bin's. */
static double end_of(uint64_t bin)
{
    double end;
    uint64_t bits = (bin + 1) << SHIFT;
    memcpy(&end, &bits, sizeof end);
    return end;
}

double histogram_quantile(const histogram *all, double share)
{
    double wanted = ceil(share * (double)all->count), seen = 0;
    if ((double)all->zeros >= wanted)
        return 0;
    for (uint64_t bin = 0; bin < HISTOGRAM_BINS; bin++) {
        seen += all->bins[bin];
        if (seen >= wanted) {
            double end = end_of(bin); /* a NaN behind infinity's bin */
            return end < all->most ? end : all->most;
        }
    }
    return all->most;
}

void tally_clear(tally *all, precision answers_in)
{
    memset(all, 0, sizeof *all);
    all->answers_in = answers_in;
}

static int class_of(double size)
{
    int exponent;
    if (size == 0)
        return 0;
    if (!(size <= 0x1p63))
        return SIZE_CLASSES - 1;
    return frexp(size, &exponent) == 0.5 ? exponent : exponent + 1; /* 1 is class 1 */
}

static void add_t(tally *all, const example *one)
{
    double ulps = error_ulps(one->given.t, one->truth.t, all->answers_in);
    if (ulps > all->t_ulps.most)
        all->sum.worst_t = *one;
    histogram_add(&all->t_ulps, ulps);
    histogram_add(&all->t_relative, error_relative(one->given.t, one->truth.t));
    all->sum.t_classes[class_of(ulps)]++;
}

static void add_normal(tally *all, const example *one)
{
    double error = error_normal(one->given.normal, one->truth.normal);
    if (error > all->normal.most)
        all->sum.worst_normal = *one;
    histogram_add(&all->normal, error);
    all->normals_right += error_normal_none(one->given.normal, one->truth.normal, all->answers_in);
}

static bool is_wrong(unsigned found)
{
    const unsigned decisions = FAULT_BIT(FAULTS_OF_DECISION) - 1;
    const unsigned answered = FAULT_BIT(FAULTS_ANSWERED) - 1;
    return (found & decisions) != 0 || (found & ~answered) != 0;
}

void tally_add(tally *all, const sure_case *question, const case_answer *truth, const reply *given)
{
    const example one = {true, *question, *given, *truth};
    verdict *sum = &all->sum;
    if (given->kind == REPLY_UNASKED) {
        sum->unasked++;
        return;
    }
    unsigned found = faults_of(question, truth, given);
    sum->cases++;
    sum->valid += truth->status != SURE_INVALID;
    sum->hits += truth->status == SURE_HIT;
    sum->wrong += truth->status != SURE_INVALID && is_wrong(found);
    for (int i = 0; i < FAULTS && found != 0; i++) {
        if ((found & FAULT_BIT(i)) != 0 && sum->faults[i]++ == 0)
            sum->faulty[i] = one;
    }
    if (!fault_is_hit(truth, given))
        return;
    add_t(all, &one);
    if (given->has_normal && (found & FAULT_BIT(FAULT_WRONG_PART)) == 0)
        add_normal(all, &one);
}

static error_summary summary_of(const histogram *sizes, uint64_t right)
{
    return (error_summary){.count = sizes->count,
                           .right = right,
                           .median = histogram_quantile(sizes, 0.5),
                           .q99 = histogram_quantile(sizes, 0.99),
                           .q9999 = histogram_quantile(sizes, 0.9999),
                           .most = sizes->most};
}

/* Whole numbers: the largest below a bin's end, unless that is the largest of all itself. */
static double whole(double end, double most)
{
    return end == 0 || end == most ? end : ceil(end) - 1;
}

static error_summary whole_ulps(error_summary of)
{
    of.median = whole(of.median, of.most);
    of.q99 = whole(of.q99, of.most);
    of.q9999 = whole(of.q9999, of.most);
    return of;
}

static error_summary normal_ulps(error_summary of, precision in)
{
    double *sizes[] = {&of.median, &of.q99, &of.q9999, &of.most};
    for (int i = 0; i < 4; i++)
        *sizes[i] = error_normal_ulps(*sizes[i], in);
    return of;
}

verdict tally_verdict(const tally *all)
{
    verdict sum = all->sum;
    const uint64_t t_right = all->t_ulps.zeros;
    sum.wrong_share = confidence_of(sum.wrong, sum.valid);
    sum.t_ulps = whole_ulps(summary_of(&all->t_ulps, t_right));
    sum.t_relative = summary_of(&all->t_relative, t_right);
    sum.normal = summary_of(&all->normal, all->normals_right);
    sum.normal_ulps = normal_ulps(sum.normal, all->answers_in);
    return sum;
}

uint64_t verdict_breaches(const verdict *of)
{
    uint64_t sum = 0;
    for (int i = FAULTS_OF_DECISION; i < FAULTS; i++)
        sum += of->faults[i];
    return sum;
}

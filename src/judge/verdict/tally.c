/* SPDX-License-Identifier: MIT */
#include "tally.h"

#include "../../numbers/places.h"

#include <math.h>
#include <string.h>

/* Faults. */

const char *fault_name(int which)
{
#define FAULT(NAME, name) name,
    static const char *const names[FAULTS] = {EACH_FAULT(FAULT)};
    return names[which];
}

/* A true hit, asked for by a query that tells its t. */
static bool is_telling(const case_answer *truth, const reply *given)
{
    return truth->status == SURE_HIT && (given->to == QUERY_HIT || given->to == QUERY_INTERVAL);
}

bool fault_is_hit(const case_answer *truth, const reply *given)
{
    return is_telling(truth, given) && given->kind == REPLY_ANSWERED && given->status == SURE_HIT;
}

static unsigned faults_of_decision(const case_answer *truth, const reply *given)
{
    if (truth->status == SURE_INVALID) {
        if (given->status != SURE_INVALID)
            return FAULT_BIT(FAULT_INVALID_ACCEPTED);
        bool other = given->field != SURE_FIELD_NONE && given->field != truth->field;
        return other ? FAULT_BIT(FAULT_WRONG_FIELD) : 0;
    }
    if (given->status == SURE_INVALID)
        return FAULT_BIT(FAULT_REFUSED);
    if (given->status != truth->status)
        return FAULT_BIT(given->status == SURE_HIT ? FAULT_FALSE_HIT : FAULT_FALSE_MISS);
    bool other = given->status == SURE_HIT && given->part != REPLY_NO_PART &&
                 given->part != (int)truth->part;
    return other ? FAULT_BIT(FAULT_WRONG_PART) : 0;
}

static unsigned faults_of_outputs(const sure_case *question, const reply *given)
{
    unsigned found = 0;
    if (given->status != SURE_HIT)
        return given->touched ? FAULT_BIT(FAULT_TOUCHED) : 0;
    if (given->to == QUERY_INTERVAL)
        return isnan(given->t) || isnan(given->t_leave) ? FAULT_BIT(FAULT_NOT_A_NUMBER) : 0;
    if (given->to != QUERY_HIT)
        return 0;
    const sure_vec3 *n = &given->normal;
    if (isnan(given->t) || (given->has_normal && (isnan(n->x) || isnan(n->y) || isnan(n->z))))
        found |= FAULT_BIT(FAULT_NOT_A_NUMBER);
    if (given->t < question->ray.t_min || given->t > question->ray.t_max)
        found |= FAULT_BIT(FAULT_OUT_OF_RANGE);
    return found;
}

unsigned faults_of(const sure_case *question, const case_answer *truth, const reply *given)
{
    unsigned found = given->leaked ? FAULT_BIT(FAULT_LEAKED) : 0;
    if (given->kind == REPLY_UNASKED)
        return found;
    if (given->kind != REPLY_ANSWERED)
        return found | FAULT_BIT(FAULT_GARBAGE + (given->kind - REPLY_GARBAGE));
    if (given->changed)
        found |= FAULT_BIT(FAULT_CHANGED);
    return found | faults_of_decision(truth, given) | faults_of_outputs(question, given);
}

/* Sizes of errors. */

/* Floats as whole numbers in their order. */
static int32_t order_of_float(float x)
{
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits < 0 ? INT32_MIN - bits : bits;
}

static double steps_of_doubles(double a, double b)
{
    int64_t x = place_of(a), y = place_of(b);
    return x < y ? (double)((uint64_t)y - (uint64_t)x) : (double)((uint64_t)x - (uint64_t)y);
}

static double steps_of_floats(float a, float b)
{
    return fabs((double)order_of_float(a) - (double)order_of_float(b));
}

/* From the nearest float, or the one on the truth's other side if that is as near. */
static double ulps_of_floats(float x, double truth)
{
    float nearest = (float)truth;
    float other = nextafterf(nearest, truth < nearest ? -INFINITY : INFINITY);
    bool as_near = fabs(truth - other) == fabs(truth - nearest);
    return fmin(steps_of_floats(x, nearest), steps_of_floats(x, as_near ? other : nearest));
}

double error_ulps(double x, double truth, precision of)
{
    if (isnan(x))
        return INFINITY;
    return of == PRECISION_FLOAT ? ulps_of_floats((float)x, truth) : steps_of_doubles(x, truth);
}

double error_relative(double x, double truth)
{
    return x == truth ? 0 : fabs(x - truth) / fabs(truth);
}

double error_normal(sure_vec3 normal, sure_vec3 truth)
{
    double x = fabs(normal.x - truth.x), y = fabs(normal.y - truth.y);
    double z = fabs(normal.z - truth.z);
    return isnan(x) || isnan(y) || isnan(z) ? INFINITY : fmax(fmax(x, y), z);
}

double error_normal_ulps(double error, precision of)
{
    return error * (of == PRECISION_FLOAT ? 0x1p23 : 0x1p52);
}

bool error_normal_none(sure_vec3 normal, sure_vec3 truth, precision of)
{
    return error_ulps(normal.x, truth.x, of) == 0 && error_ulps(normal.y, truth.y, of) == 0 &&
           error_ulps(normal.z, truth.z, of) == 0;
}

/* Shares of them. */

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

void histogram_add_bin(histogram *all, int bin, uint64_t count)
{
    all->bins[bin] += count;
    all->binades[bin / HISTOGRAM_PARTS] += count;
    all->count += count;
}

void histogram_add(histogram *all, double size)
{
    if (isnan(size))
        size = INFINITY;
    histogram_add_bin(all, (int)(bits_of(size) >> SHIFT), 1);
    all->zeros += size == 0;
    if (size > all->most)
        all->most = size;
}

double histogram_quantile(const histogram *all, double share)
{
    uint64_t wanted = (uint64_t)ceil(share * (double)all->count), bin = 0;
    if (all->zeros >= wanted)
        return 0;
    for (; all->binades[bin / HISTOGRAM_PARTS] < wanted; bin += HISTOGRAM_PARTS)
        wanted -= all->binades[bin / HISTOGRAM_PARTS];
    for (; all->bins[bin] < wanted; bin++)
        wanted -= all->bins[bin];
    double end = double_of((bin + 1) << SHIFT); /* a NaN behind infinity's bin */
    return end < all->most ? end : all->most;
}

/* The tally. */

static int class_of(double size)
{
    int exponent;
    if (size == 0)
        return 0;
    if (!(size <= 0x1p63))
        return SIZE_CLASSES - 1;
    return frexp(size, &exponent) == 0.5 ? exponent : exponent + 1; /* 1 is class 1 */
}

double example_ulps(const example *one, precision in)
{
    double ulps = error_ulps(one->given.t, one->truth.t, in);
    if (one->given.to == QUERY_HIT)
        return ulps;
    return fmax(ulps, error_ulps(one->given.t_leave, one->truth.t_leave, in));
}

static void add_end(tally *all, double given, double truth)
{
    double ulps = error_ulps(given, truth, all->answers_in);
    histogram_add(&all->t_ulps, ulps);
    histogram_add(&all->t_relative, error_relative(given, truth));
    all->sum.t_classes[class_of(ulps)]++;
}

static void add_t(tally *all, const example *one)
{
    if (example_ulps(one, all->answers_in) > all->t_ulps.most)
        all->sum.worst_t = *one;
    add_end(all, one->given.t, one->truth.t);
    if (one->given.to == QUERY_INTERVAL)
        add_end(all, one->given.t_leave, one->truth.t_leave);
}

/* What is behind the eye, where a chord may begin, is in no pixel. */
static void add_lengths(tally *all, const example *one, const camera_lengths *by)
{
    double t = one->truth.t, off = one->given.t == t ? 0 : fabs(one->given.t - t) * by->speed;
    double way = by->way + t * by->speed;
    histogram_add(&all->t_extents, off / by->extent);
    if (way > 0)
        histogram_add(&all->t_pixels, off / (by->pixel * way));
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

void tally_add(tally *all, const example *one, unsigned found, const camera_lengths *by)
{
    const case_answer *truth = &one->truth;
    const reply *given = &one->given;
    verdict *sum = &all->sum;
    if (given->kind == REPLY_UNASKED) {
        sum->unasked++;
        return;
    }
    sum->cases++;
    sum->valid += truth->status != SURE_INVALID;
    sum->hits += truth->status == SURE_HIT;
    sum->with_t += is_telling(truth, given);
    sum->with_normal += is_telling(truth, given) && given->to == QUERY_HIT;
    sum->wrong += truth->status != SURE_INVALID && is_wrong(found);
    for (int i = 0; i < FAULTS && found != 0; i++) {
        if ((found & FAULT_BIT(i)) != 0 && sum->faults[i]++ == 0)
            sum->faulty[i] = *one;
    }
    if (!fault_is_hit(truth, given))
        return;
    add_t(all, one);
    if (by)
        add_lengths(all, one, by);
    if (given->has_normal && (found & FAULT_BIT(FAULT_WRONG_PART)) == 0)
        add_normal(all, one);
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
    sum.t_extents = summary_of(&all->t_extents, t_right);
    sum.t_pixels = summary_of(&all->t_pixels, t_right);
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

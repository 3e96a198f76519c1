/* SPDX-License-Identifier: MIT */
#include "shrink.h"

#include "verdict/tally.h"

#include <surehit/bounds.h>

#include <math.h>
#include <string.h>

/* To how many bits mantissas are cut, where not to any number of them. */
static const int coarse_bits[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 40, 48};
#define COARSE (int)(sizeof coarse_bits / sizeof *coarse_bits)

/* Simpler values for x, simplest first: proposal `n`; NaN when there are no more. */
static double simpler(double x, int n, bool coarsely)
{
    const int cuts = coarsely ? COARSE : 52;
    static const double plain[] = {0, 1, -1};
    if (n < 3)
        return plain[n];
    if (!isfinite(x))
        return NAN;
    int exponent;
    double mantissa = frexp(x, &exponent);
    n -= 3;
    if (n < cuts) {
        int bits = coarsely ? coarse_bits[n] : n + 1;
        return ldexp(trunc(ldexp(mantissa, bits)), exponent - bits);
    }
    n -= cuts;
    if (n < 4) /* the exponent brought nearer to zero: at once, halved, by eight, by one */
        return ldexp(mantissa, n == 0   ? 1
                               : n == 1 ? exponent / 2
                               : n == 2 ? exponent - (exponent > 8) * 8 + (exponent < -8) * 8
                                        : exponent - (exponent > 1) + (exponent < 0));
    return NAN;
}

/* How much there is to read in x: the order by which a proposal is simpler. */
static int weight(double x)
{
    if (x == 0)
        return 0;
    if (!isfinite(x))
        return 5000;
    int exponent, bits = 0;
    double rest = fabs(frexp(x, &exponent));
    for (; rest != 0; bits++)
        rest = 2 * rest - trunc(2 * rest);
    return 1 + (x < 0) + 4 * bits + (exponent < 0 ? -exponent : exponent);
}

sure_case shrink_case(const sure_case *question, bool coarsely, case_fails *fails, void *context)
{
    sure_case simple = *question;
    for (bool better = true; better;) {
        better = false;
        for (int i = 0; i < case_numbers(question->object.shape); i++) {
            double *number = case_number(&simple, i), kept = *number, proposal;
            bool found = false;
            for (int n = 0; !found && !isnan(proposal = simpler(kept, n, coarsely)); n++) {
                *number = proposal;
                found = weight(proposal) < weight(kept) && fails(&simple, context);
            }
            if (!found)
                *number = kept;
            better |= found;
        }
    }
    return simple;
}

/* Tiers. */

/* What is wrong with a tier's answer, `exact` being right, as faults of the judge; and, of a right
 * decision: */
#define WRONG_T FAULT_BIT(FAULTS)
#define WRONG_NORMAL FAULT_BIT(FAULTS + 1)

/* How a case fails: made simpler, it has to fail in the same way. */
typedef struct {
    sure_tier tier;
    against by;
    unsigned what;
} failure;

/* Surely farther off: exact's t is rounded, and the real one between its neighbours. */
static bool is_off(double given, double right, double error)
{
    double low = nextafter(right, -INFINITY), high = nextafter(right, INFINITY);
    return !(given >= low - error && given <= high + error);
}

static bool is_off_normal(sure_vec3 given, sure_vec3 right)
{
    const double error = SURE_NORMAL_ERROR;
    return is_off(given.x, right.x, error) || is_off(given.y, right.y, error) ||
           is_off(given.z, right.z, error);
}

static unsigned wrong_of(const sure_case *question, sure_tier tier, against by)
{
    const unsigned range = FAULT_BIT(FAULT_OUT_OF_RANGE);
    const unsigned of_invalid = FAULT_BIT(FAULT_INVALID_ACCEPTED) | FAULT_BIT(FAULT_WRONG_FIELD);
    const unsigned decision = (FAULT_BIT(FAULTS_OF_DECISION) - 1) | of_invalid;
    const case_answer given = case_answer_of(question, tier);
    const case_answer right = case_answer_of(question, SURE_TIER_EXACT);
    const reply said = reply_of(&given, QUERY_HIT);
    unsigned found = faults_of(question, &right, &said);
    if ((found & decision) != 0 || given.status != SURE_HIT || by == AGAINST_DECISION)
        return found & decision;
    bool same_t = memcmp(&given.t, &right.t, sizeof given.t) == 0;
    bool same_normal = memcmp(&given.normal, &right.normal, sizeof given.normal) == 0;
    if (by == AGAINST_PROMISE) {
        sure_hit hit = {0};
        (void)sure_object_hit(&question->ray, &question->object, tier, &hit);
        if ((found & range) != 0)
            return range;
        same_t = !is_off(given.t, right.t, hit.t_error);
        same_normal = !is_off_normal(given.normal, right.normal);
    }
    return !same_t ? WRONG_T : !same_normal ? WRONG_NORMAL : 0;
}

static bool fails_alike(const sure_case *question, void *context)
{
    const failure *first = context;
    return wrong_of(question, first->tier, first->by) == first->what;
}

bool tier_failure_simple(const sure_case *question, sure_tier tier, against by, sure_case *simple)
{
    failure found = {tier, by, wrong_of(question, tier, by)};
    if (found.what != 0)
        *simple = shrink_case(question, false, fails_alike, &found);
    return found.what != 0;
}

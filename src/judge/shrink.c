#include "shrink.h"

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

/* What can be wrong with a tier's answer, `exact` being right. */
typedef enum {
    RIGHT,
    WRONG_STATUS,
    WRONG_FIELD,
    WRONG_PART,
    WRONG_T,
    WRONG_NORMAL,
    WRONG_RANGE, /* t outside [t_min, t_max] */
    WRONG_ERROR  /* t farther off than it says */
} wrong;

/* How a case fails: made simpler, it has to fail in the same way. */
typedef struct {
    sure_tier tier;
    against by;
    wrong what;
    sure_status status, right_status;
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

static wrong wrong_of(const sure_case *question, sure_tier tier, against by,
                      const case_answer *given, const case_answer *right)
{
    sure_hit hit = {0};
    if (given->status != right->status)
        return WRONG_STATUS;
    if (given->field != right->field)
        return WRONG_FIELD;
    if (given->part != right->part)
        return WRONG_PART;
    if (given->status != SURE_HIT || by == AGAINST_DECISION)
        return RIGHT;
    if (by == AGAINST_ANSWER) {
        if (memcmp(&given->t, &right->t, sizeof given->t) != 0)
            return WRONG_T;
        bool same = memcmp(&given->normal, &right->normal, sizeof given->normal) == 0;
        return same ? RIGHT : WRONG_NORMAL;
    }
    (void)sure_object_hit(&question->ray, &question->object, tier, &hit);
    if (!(given->t >= question->ray.t_min && given->t <= question->ray.t_max))
        return WRONG_RANGE;
    if (is_off(given->t, right->t, hit.t_error))
        return WRONG_ERROR;
    return is_off_normal(given->normal, right->normal) ? WRONG_NORMAL : RIGHT;
}

static failure failure_of(const sure_case *question, sure_tier tier, against by)
{
    case_answer given = case_answer_of(question, tier);
    case_answer right = case_answer_of(question, SURE_TIER_EXACT);
    wrong what = wrong_of(question, tier, by, &given, &right);
    return (failure){tier, by, what, given.status, right.status};
}

static bool fails_alike(const sure_case *question, void *context)
{
    const failure *first = context;
    failure now = failure_of(question, first->tier, first->by);
    return now.what == first->what && now.status == first->status &&
           now.right_status == first->right_status;
}

bool tier_failure_simple(const sure_case *question, sure_tier tier, against by, sure_case *simple)
{
    failure found = failure_of(question, tier, by);
    if (found.what == RIGHT)
        return false;
    *simple = shrink_case(question, false, fails_alike, &found);
    return true;
}

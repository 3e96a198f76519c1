#include "shrink.h"

#include <math.h>

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
    sure_shape shape = question->object.shape;
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(question, numbers);
    for (bool better = true; better;) {
        better = false;
        for (int i = 0; i < case_numbers(shape); i++) {
            double kept = numbers[i], proposal;
            for (int n = 0; !isnan(proposal = simpler(kept, n, coarsely)); n++) {
                if (weight(proposal) >= weight(kept))
                    continue;
                numbers[i] = proposal;
                sure_case candidate = case_from_numbers(shape, numbers);
                if (fails(&candidate, context)) {
                    better = true;
                    break;
                }
                numbers[i] = kept;
            }
        }
    }
    return case_from_numbers(shape, numbers);
}

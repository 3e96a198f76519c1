/* SPDX-License-Identifier: MIT */
/* The routine of test_package.mjs for the native judge. */
#include <surehit/candidate.h>

#include <math.h>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

int sure_candidate_sphere(const double *ray, const double *sphere, sure_candidate_hit *hit)
{
    double a = 0, half = 0, c = -sphere[3] * sphere[3];
    for (int i = 0; i < 3; i++) {
        double m = ray[i] - sphere[i], d = ray[3 + i];
        a += d * d;
        half += m * d;
        c += m * m;
    }
    double root = sqrt(half * half - a * c), near = (-half - root) / a;
    double t = near >= ray[6] ? near : (-half + root) / a;
    if (!(t >= ray[6] && t <= ray[7]))
        return SURE_CANDIDATE_MISS;
    hit->t = t;
    return SURE_CANDIDATE_HIT;
}

/* SPDX-License-Identifier: MIT */
/* A sphere by the quadratic formula, as one writes it at first. To be judged:
 *
 *     cc -O2 -shared -fPIC -Iinclude docs/examples/sphere.c -o sphere.so -lm
 *     ./run judge --candidate ./sphere.so
 */
#include <math.h>
#include <surehit/candidate.h>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

int sure_candidate_sphere(const double *ray, const double *sphere, sure_candidate_hit *hit)
{
    double a = 0, half_b = 0, c = -sphere[3] * sphere[3];
    for (int i = 0; i < 3; i++) {
        double m = ray[i] - sphere[i], d = ray[3 + i];
        a += d * d;
        half_b += m * d;
        c += m * m;
    }
    double root = sqrt(half_b * half_b - a * c);
    double t = (-half_b - root) / a;
    if (t < ray[6])
        t = (-half_b + root) / a;
    if (!(t >= ray[6] && t <= ray[7]))
        return SURE_CANDIDATE_MISS;
    hit->t = t;
    return SURE_CANDIDATE_HIT;
}

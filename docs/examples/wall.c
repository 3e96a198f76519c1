/* SPDX-License-Identifier: MIT */
/* A quadric without caps, as renderers have it: the infinite cylinder, in textbook double. */
#include <math.h>
#include <surehit/candidate.h>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;
const char sure_candidate_entry[] = "wall";

static double dot(const double *u, const double *v)
{
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/* ray: o, d, t_min, t_max; cylinder: base, top, radius */
int sure_candidate_cylinder(const double *ray, const double *cylinder, sure_candidate_hit *hit)
{
    double axis[3], m[3];
    for (int i = 0; i < 3; i++) {
        axis[i] = cylinder[3 + i] - cylinder[i];
        m[i] = ray[i] - cylinder[i];
    }
    const double *d = ray + 3;
    double square = dot(axis, axis), d_share = dot(axis, d) / square,
           m_share = dot(axis, m) / square;
    double a = dot(d, d) - dot(axis, d) * d_share, half_b = dot(m, d) - dot(axis, m) * d_share;
    double c = dot(m, m) - dot(axis, m) * m_share - cylinder[6] * cylinder[6];
    double root = sqrt(half_b * half_b - a * c), near = (-half_b - root) / a;
    double t = near >= ray[6] ? near : (-half_b + root) / a;
    if (!(t >= ray[6] && t <= ray[7]))
        return SURE_CANDIDATE_MISS;
    hit->t = t;
    return SURE_CANDIDATE_HIT;
}

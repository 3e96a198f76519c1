/* SPDX-License-Identifier: MIT */
/* Stands for the quadratic solved with the greatest care, after its coefficients have been rounded:
 * b^2 - a c from both products and their errors, which an FMA tells, and the second root by Vieta.
 *
 *     W. Kahan: On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic. 2004,
 *     https://people.eecs.berkeley.edu/~wkahan/Qdrtcs.pdf (quadratic, discriminant)
 *     C.-P. Jeannerod, N. Louvet, J.-M. Muller: Further analysis of Kahan's algorithm for the
 *     accurate computation of 2 x 2 determinants. Mathematics of Computation 82 (2013): 1.5 ulps
 *
 *     q = -(b + sign(b) sqrt(b^2 - a c)),  t = q / a, c / q
 *
 * Sphere, cylinder and cone have the textbook's coefficients (textbook_solids.h). */
#include "peer.h"
#include "textbook_solids.h"

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

/* b b - a c, right to 1.5 ulps unless a product over- or underflows. */
static real difference_of_products(real b, real a, real c)
{
    real product = a * c;
    real error = fma(-a, c, product);
    return fma(b, b, -product) + error;
}

static int solve(real a, real b, real c, real roots[2])
{
    real discriminant = difference_of_products(b, a, c);
    if (!(discriminant >= 0))
        return 0;
    real q = -(b + copysign(square_root(discriminant), b));
    roots[0] = q / a;
    roots[1] = q == 0 ? roots[0] : c / q;
    return 1;
}

int PEER(sphere)(const real *numbers, const real *sphere, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 m = sub(ray.o, vector(sphere));
    real roots[2];
    if (!solve(dot(ray.d, ray.d), dot(m, ray.d), dot(m, m) - sphere[3] * sphere[3], roots))
        return SURE_CANDIDATE_MISS;
    int swapped = roots[1] < roots[0];
    return found_first(&ray, roots[swapped], roots[!swapped], hit);
}

int PEER(cylinder)(const real *numbers, const real *cylinder, peer_hit *hit)
{
    return textbook_cylinder(numbers, cylinder, hit);
}

int PEER(cone)(const real *numbers, const real *cone, peer_hit *hit)
{
    return textbook_cone(numbers, cone, hit);
}

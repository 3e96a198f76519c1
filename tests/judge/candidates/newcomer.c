/* What stands before the README's lines, where one's own routine is: the sphere by D/4. */
#include <math.h>
#include <surehit/candidate.h>

static double my_sphere(const double *ray, const double *sphere)
{
    double a = 0, b = 0, c = -sphere[3] * sphere[3];
    for (int i = 0; i < 3; i++) {
        double m = ray[i] - sphere[i], d = ray[3 + i];
        a += d * d;
        b += m * d;
        c += m * m;
    }
    double root = sqrt(b * b - a * c), t = (-b - root) / a;
    return t >= ray[6] ? t : (-b + root) / a;
}


#include "error_size.h"

#include <math.h>
#include <string.h>

/* Doubles, and floats, as whole numbers in their order. */
static int64_t order_of_double(double x)
{
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits < 0 ? INT64_MIN - bits : bits;
}

static int32_t order_of_float(float x)
{
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits < 0 ? INT32_MIN - bits : bits;
}

static double steps_of_doubles(double a, double b)
{
    int64_t x = order_of_double(a), y = order_of_double(b);
    return x < y ? (double)((uint64_t)y - (uint64_t)x) : (double)((uint64_t)x - (uint64_t)y);
}

static double steps_of_floats(float a, float b)
{
    return fabs((double)order_of_float(a) - (double)order_of_float(b));
}

/* The float on the truth's other side, if it is as near; else the nearest itself. */
static float equally_near(float nearest, double truth)
{
    float other = nextafterf(nearest, truth < nearest ? -INFINITY : INFINITY);
    return fabs(truth - other) == fabs(truth - nearest) ? other : nearest;
}

static double ulps_of_floats(float x, double truth)
{
    float nearest = (float)truth;
    return fmin(steps_of_floats(x, nearest), steps_of_floats(x, equally_near(nearest, truth)));
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

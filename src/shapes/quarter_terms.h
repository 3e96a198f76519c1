/* The discriminant of a body's quadratic but for a positive factor, as the difference of two terms
 * that are near each other only where the ray grazes (quarter.h names them), in two kinds of
 * numbers. */
#ifndef SHAPES_QUARTER_TERMS_H
#define SHAPES_QUARTER_TERMS_H

#include "../numbers/modular.h"
#include "../numbers/pair.h"

#include <surehit/object.h>

/* Its value nearly, and the sum of both terms. */
typedef struct {
    pair value;
    double terms;
} quarter_pair;

quarter_pair sphere_quarter_pair(const sure_ray *ray, const sure_sphere *sphere);
quarter_pair cylinder_quarter_pair(const sure_ray *ray, const sure_cylinder *cylinder);
quarter_pair cone_quarter_pair(const sure_ray *ray, const sure_cone *cone);

#ifdef MODULAR_EXISTS
/* Its value is an integer times 2^exponent; the integer's last 128 digits. Are those of both terms
 * zero? */
typedef struct {
    modular value;
    int exponent;
    bool terms_are_zero;
} quarter_modular;

quarter_modular sphere_quarter_modular(const sure_ray *ray, const sure_sphere *sphere);
quarter_modular cylinder_quarter_modular(const sure_ray *ray, const sure_cylinder *cylinder);
quarter_modular cone_quarter_modular(const sure_ray *ray, const sure_cone *cone);

/* A line seen from an axis's first end, A leading to the other: A.d, and A.m and A.m - A.A, which
 * are counted alike. */
typedef struct {
    modular speed, from, to;
    int speed_exponent, exponent;
} axis_modular;

axis_modular axis_line_modular(const sure_ray *ray, sure_vec3 from, sure_vec3 to);

/* Where the digits are all of the number. Entry: round to nearest; exponent as modular_value has
 * it. */
near quarter_modular_value(const quarter_modular *digits);
#endif

#endif

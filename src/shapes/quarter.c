#include "quarter.h"

#include "../numbers/environment.h"
#include "quarter_terms.h"

#include <surehit/bounds.h>

#include <math.h>

/* The filters' bounds of D are taken for pairs; the sphere's D has fewer roundings than the
 * cylinder's. */
#define QUARTER_FLOOR 0x1p-900

static double square_between(sure_vec3 from, sure_vec3 to)
{
    double x = to.x - from.x, y = to.y - from.y, z = to.z - from.z;
    return x * x + y * y + z * z;
}

/* What D is measured by: G in the filters' proofs. */
static double measure_of(const sure_ray *ray, sure_shape shape, const void *object, double *bound)
{
    const sure_vec3 zero = {0, 0, 0};
    double dd = square_between(zero, ray->direction);
    *bound = SURE_CYLINDER_DISCRIMINANT_BOUND * PAIR_SHARE;
    if (shape == SURE_SHAPE_SPHERE) {
        const sure_sphere *s = object;
        return dd * (square_between(s->centre, ray->origin) + s->radius * s->radius);
    }
    if (shape == SURE_SHAPE_CYLINDER) {
        const sure_cylinder *s = object;
        double reach = square_between(s->base, ray->origin) + s->radius * s->radius;
        return square_between(s->base, s->top) * dd * reach;
    }
    const sure_cone *s = object;
    double height = square_between(s->apex, s->base), slant = height + s->radius * s->radius;
    *bound = SURE_CONE_DISCRIMINANT_BOUND * PAIR_SHARE;
    return slant * (height * dd) * square_between(s->apex, ray->origin);
}

static quarter_pair by_pairs(const sure_ray *ray, sure_shape shape, const void *object)
{
    return shape == SURE_SHAPE_SPHERE     ? sphere_quarter_pair(ray, object)
           : shape == SURE_SHAPE_CYLINDER ? cylinder_quarter_pair(ray, object)
                                          : cone_quarter_pair(ray, object);
}

/* The whole of a D of at most that magnitude, by its last digits; and do both of its terms vanish,
 * of which none is more than that? */
static bool by_digits(const sure_ray *ray, sure_shape shape, const void *object, double most,
                      double most_of_terms, near *value, bool *vanishes)
{
#ifdef MODULAR_EXISTS
    quarter_modular digits = shape == SURE_SHAPE_SPHERE     ? sphere_quarter_modular(ray, object)
                             : shape == SURE_SHAPE_CYLINDER ? cylinder_quarter_modular(ray, object)
                                                            : cone_quarter_modular(ray, object);
    if (!modular_is_whole(most, digits.exponent))
        return false;
    *value = (near){0, 0, 0};
    *vanishes = digits.terms_are_zero && modular_is_whole(most_of_terms, digits.exponent);
    if (digits.value == 0)
        return true;
    TO_NEAREST(*value, quarter_modular_value(&digits));
    return digits.exponent >= -1022 && digits.exponent <= 800;
#else
    (void)ray, (void)shape, (void)object, (void)most, (void)most_of_terms, (void)value;
    *vanishes = false;
    return false;
#endif
}

bool quarter_of(const sure_ray *ray, sure_shape shape, const void *object, quarter *found)
{
    double bound, measure = measure_of(ray, shape, object, &bound);
    quarter_pair nearly;
    TO_NEAREST(nearly, by_pairs(ray, shape, object));
    double value = nearly.value.head, rest = nearly.value.tail;
    double error_square = bound * bound * nearly.terms * measure + QUARTER_FLOOR;
    double error = sqrt(error_square) * (1 + 0x1p-40);
    if (value * value > error_square) {
        *found = (quarter){
            .value = value, .rest = rest, .error = error, .stage = SURE_STAGE_DOUBLE_DOUBLE};
        return true;
    }
    /* Where the sign is not certain the terms may be off by more than they are. */
    error += bound * bound * measure;
    double most = (fabs(value) + fabs(rest) + error) * (1 + 0x1p-40);
    near whole;
    bool vanishes;
    if (!by_digits(ray, shape, object, most, nearly.terms + error, &whole, &vanishes))
        return false;
    *found = (quarter){.value = whole.hi,
                       .rest = whole.lo,
                       .error = whole.error,
                       .vanishes = vanishes,
                       .stage = SURE_STAGE_RESIDUE};
    return true;
}

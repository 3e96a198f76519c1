/* With m = o - C, Q or base, A from there to the other end, w = d x m:
 *
 *     sphere     r^2 d.d - w.w
 *     cylinder   r^2 X.X - (X.m)^2,     X = A x d
 *     cone       r^2 g.g - H (A.w)^2,   g = A x w, H = A.A
 *
 * The filters derive these; the chords of the other stages have their own. Each kind of numbers,
 * those of A, m, d and r, has its context, since integers are counted in units of their kind. */
#include "quarter_terms.h"

#include "../numbers/number.h"

#if !defined SURE_MODULAR || defined MODULAR_EXISTS

typedef struct {
    context axis, m, d, r;
} kinds;

typedef struct {
    vector axis, m, d;
    number rr;
} parts;

#ifdef SURE_PAIR
typedef quarter_pair quarter_terms;
#define UNIT(kind) 0

static inline kinds kinds_of(const sure_ray *ray, sure_vec3 from, sure_vec3 to, double radius)
{
    (void)ray, (void)from, (void)to, (void)radius;
    return (kinds){{0}, {0}, {0}, {0}};
}

static inline quarter_terms difference_of(kinds *k, number inner, number outer, int inner_unit,
                                          int outer_unit)
{
    (void)inner_unit, (void)outer_unit;
    return (quarter_pair){number_sub(&k->d, inner, outer), inner.head + outer.head};
}
#else
typedef quarter_modular quarter_terms;
#define UNIT(kind) k.kind.exponent

static inline void fit(context *unit, sure_vec3 v)
{
    modular_fit(unit, v.x);
    modular_fit(unit, v.y);
    modular_fit(unit, v.z);
}

static inline kinds kinds_of(const sure_ray *ray, sure_vec3 from, sure_vec3 to, double radius)
{
    const context any = {MODULAR_UNIT_OF_ZEROS};
    kinds k = {any, any, any, any};
    fit(&k.axis, from);
    k.m = k.axis;
    fit(&k.m, ray->origin);
    fit(&k.axis, to);
    fit(&k.d, ray->direction);
    modular_fit(&k.r, radius);
    return k;
}

static inline quarter_terms difference_of(kinds *k, number inner, number outer, int inner_unit,
                                          int outer_unit)
{
    (void)k;
    int exponent = inner_unit < outer_unit ? inner_unit : outer_unit;
    inner = modular_shifted(inner, inner_unit - exponent);
    outer = modular_shifted(outer, outer_unit - exponent);
    return (quarter_modular){inner - outer, exponent, inner == 0 && outer == 0};
}

axis_modular axis_line_modular(const sure_ray *ray, sure_vec3 from, sure_vec3 to)
{
    kinds k = kinds_of(ray, from, to, 0);
    vector axis = vector_between(&k.axis, from, to), m = vector_between(&k.m, from, ray->origin);
    modular height = vector_square(&k.axis, axis), along = vector_dot(&k.d, axis, m);
    int exponent = UNIT(axis) < UNIT(m) ? UNIT(axis) : UNIT(m);
    along = modular_shifted(along, UNIT(m) - exponent);
    height = modular_shifted(height, UNIT(axis) - exponent);
    return (axis_modular){vector_dot(&k.d, axis, vector_of(&k.d, ray->direction)), along,
                          along - height, UNIT(axis) + UNIT(d), UNIT(axis) + exponent};
}

near quarter_modular_value(const quarter_modular *digits)
{
    return modular_value(digits->value, digits->exponent);
}
#endif

static inline parts parts_of_object(kinds *k, const sure_ray *ray, sure_vec3 from, sure_vec3 to,
                                    double radius)
{
    return (parts){.axis = vector_between(&k->axis, from, to),
                   .m = vector_between(&k->m, from, ray->origin),
                   .d = vector_of(&k->d, ray->direction),
                   .rr = number_square(&k->r, number_of(&k->r, radius))};
}

quarter_terms STAGE(sphere_quarter)(const sure_ray *ray, const sure_sphere *sphere)
{
    sure_vec3 centre = sphere->centre;
    kinds k = kinds_of(ray, centre, centre, sphere->radius);
    parts p = parts_of_object(&k, ray, centre, centre, sphere->radius);
    number inner = number_mul(&k.d, p.rr, vector_square(&k.d, p.d));
    number outer = vector_square(&k.d, vector_cross(&k.d, p.d, p.m));
    return difference_of(&k, inner, outer, 2 * (UNIT(r) + UNIT(d)), 2 * (UNIT(d) + UNIT(m)));
}

quarter_terms STAGE(cylinder_quarter)(const sure_ray *ray, const sure_cylinder *cylinder)
{
    kinds k = kinds_of(ray, cylinder->base, cylinder->top, cylinder->radius);
    parts p = parts_of_object(&k, ray, cylinder->base, cylinder->top, cylinder->radius);
    vector across = vector_cross(&k.d, p.axis, p.d);
    number inner = number_mul(&k.d, p.rr, vector_square(&k.d, across));
    number outer = number_square(&k.d, vector_dot(&k.d, across, p.m));
    int across_unit = UNIT(axis) + UNIT(d);
    return difference_of(&k, inner, outer, 2 * (UNIT(r) + across_unit),
                         2 * (across_unit + UNIT(m)));
}

quarter_terms STAGE(cone_quarter)(const sure_ray *ray, const sure_cone *cone)
{
    kinds k = kinds_of(ray, cone->apex, cone->base, cone->radius);
    parts p = parts_of_object(&k, ray, cone->apex, cone->base, cone->radius);
    vector w = vector_cross(&k.d, p.d, p.m), g = vector_cross(&k.d, p.axis, w);
    number inner = number_mul(&k.d, p.rr, vector_square(&k.d, g));
    number miss = number_square(&k.d, vector_dot(&k.d, p.axis, w));
    number outer = number_mul(&k.d, vector_square(&k.d, p.axis), miss);
    int moment_unit = UNIT(axis) + UNIT(d) + UNIT(m);
    return difference_of(&k, inner, outer, 2 * (UNIT(r) + moment_unit),
                         2 * (UNIT(axis) + moment_unit));
}

#endif

/* The stable tier's view of an object along a ray. It is taken in double where that is enough;
 * where terms cancel it is taken again with twice the digits, and where products would leave the
 * range, with powers of two taken out. */
#ifndef SHAPES_SIGHT_H
#define SHAPES_SIGHT_H

#include "../numbers/scale.h"
#include "span.h"

/* o + t d as seen from `from`, of which only the direction counts: stable, a quarter of it where it
 * overflows. */
static inline vec3 sight_point(const sure_ray *ray, double t, sure_vec3 from)
{
    vec3 point = span_point(ray, t, from);
#ifdef SURE_STABLE
    if (!scale_is_finite(point))
        point = vec3_add(scale_between(from, ray->origin, 0.25),
                         vec3_scale(t / 4, vec3_from(ray->direction)));
#endif
    return point;
}

#ifdef SURE_STABLE
#include "../geometry/quadratic.h"
#include "../numbers/twice.h"

#include <stddef.h>

/* Terms cancel when their sum is less than this share of them: some ten of 53 bits are lost. */
#define SIGHT_CANCELLED 0x1p-10
/* For heights, whose error the bound of t measures against N.d: some twenty. */
#define SIGHT_LEVELLED 0x1p-20
/* Squares that are smaller than this share of others': their roots have lost some twenty bits. */
#define SIGHT_SMALL 0x1p-40
/* The square of a small angle's sine, below which its digits are counted. */
#define SIGHT_NARROW 0x1p-8
/* The square of r / |n| of a cone so slim that its digits are counted. */
#define SIGHT_SLIM 0x1p-24
/* Of these nothing may be left. */
#define SIGHT_LOST 0x1p-80

/* Out of the way of what is done for every ray. */
#ifdef __GNUC__
#define SIGHT_SELDOM __attribute__((noinline))
#else
#define SIGHT_SELDOM
#endif

/* By what a chord is told. The body is a t^2 + 2 half_b t + c <= 0 with D/4 = (factor^2) quarter;
 * the object's planes lie across n, the origin is at these heights over them. */
typedef struct {
    real a, half_b, c, quarter, factor;
    real speed, over, over_to; /* n.d, n.(o - from), n.(o - to) */
    real margin;               /* of a disc: not negative where it is met */
    bool past_end;             /* the line goes through `to`, exactly */
    int shift;                 /* 2^shift times a t of here is the ray's */
} sight;

/* What a look in double is worth. */
typedef enum {
    SIGHT_CLEAR, /* all of it is good */
    SIGHT_LEVEL, /* the heights have to be taken again, */
    SIGHT_HARD,  /* ... everything has to be taken again, */
    SIGHT_WILD   /* ... near one */
} sight_verdict;

/* Entry: quarter >= 0. */
static inline void sight_roots(const sight *s, real roots[2])
{
    quadratic_pair(s->a, s->half_b, s->c, s->factor * sqrt(s->quarter), roots);
}

static inline span sight_span(span found, const sight *s)
{
    if (s->shift != 0) {
        found.enter = ldexp(found.enter, s->shift);
        found.leave = ldexp(found.leave, s->shift);
    }
    return found;
}

static inline bool sight_cancels(real sum, real terms)
{
    return fabs(sum) < SIGHT_CANCELLED * terms;
}

/* Do the terms of v.w cancel? */
static inline bool sight_dot_cancels(real dot, vec3 v, vec3 w)
{
    return fabs(dot) < SIGHT_LEVELLED * (fabs(v.x * w.x) + fabs(v.y * w.y) + fabs(v.z * w.z));
}

/* What the object is made of: one point or two, and a normal or the way between the two. */
typedef struct {
    const sure_vec3 *from, *to; /* the same point where there is one */
    const sure_vec3 *normal;    /* NULL for the way */
    double radius;
    bool radius_with_n; /* a cone: its shape is radius over |n| */
} sight_of;

/* d, m = o - from, m_to = o - to, n and r in double, ... */
typedef struct {
    vec3 d, m, m_to, n;
    real r;
} sight_parts;

/* ... and with twice the digits. Near one, the lengths m, m_to and r, or n and r, are over one
 * power of two; only a cone's r may then be large, up to 2^480. */
typedef struct {
    twice_vec3 d, m, m_to, n;
    twice r;
    int shift;
} twice_sight;

/* unit (to - from) */
static inline twice_vec3 sight_way(const sure_vec3 *from, const sure_vec3 *to, real unit)
{
    return (twice_vec3){two_sum(unit * to->x, -(unit * from->x)),
                        two_sum(unit * to->y, -(unit * from->y)),
                        two_sum(unit * to->z, -(unit * from->z))};
}

static inline twice_vec3 sight_given(sure_vec3 v)
{
    return (twice_vec3){{v.x, 0}, {v.y, 0}, {v.z, 0}};
}

static inline twice_sight sight_in(const sure_ray *ray, const sight_of *object, real unit)
{
    return (twice_sight){
        .d = sight_given(ray->direction),
        .m = sight_way(object->from, &ray->origin, unit),
        .m_to = sight_way(object->to, &ray->origin, unit),
        .n = object->normal ? sight_given(*object->normal)
                            : sight_way(object->from, object->to, unit),
        .r = {unit * object->radius, 0},
    };
}

static inline bool sight_is_finite(const twice_sight *s)
{
    return scale_is_finite(twice_head(&s->m)) && scale_is_finite(twice_head(&s->m_to)) &&
           scale_is_finite(twice_head(&s->n));
}

static inline real twice_largest(const twice_vec3 *v)
{
    return scale_largest(twice_head(v));
}

static twice_sight sight_near_one(const sure_ray *ray, const sight_of *object)
{
    twice_sight s = sight_in(ray, object, 1);
    if (!sight_is_finite(&s)) { /* a quarter of a difference does not overflow */
        s = sight_in(ray, object, 0.25);
        s.shift = 2;
    }
    real length = scale_larger(twice_largest(&s.m), twice_largest(&s.m_to));
    int of_d = scale_exponent(twice_largest(&s.d)), of_n = scale_exponent(twice_largest(&s.n));
    int of_r = scale_exponent(s.r.head);
    int of_m = scale_exponent(object->radius_with_n ? length : scale_larger(length, s.r.head));
    if (object->radius_with_n && of_r - 480 > of_n)
        of_n = of_r - 480;
    s.d = twice_scaled(&s.d, -of_d);
    s.m = twice_scaled(&s.m, -of_m);
    s.m_to = twice_scaled(&s.m_to, -of_m);
    s.n = twice_scaled(&s.n, -of_n);
    s.r.head = ldexp(s.r.head, object->radius_with_n ? -of_n : -of_m);
    s.shift += of_m - of_d;
    return s;
}

static inline void sight_heights(const twice_sight *from, sight *s)
{
    s->speed = twice_rounded(twice_dot(&from->n, &from->d));
    s->over = twice_rounded(twice_dot(&from->n, &from->m));
    s->over_to = twice_rounded(twice_dot(&from->n, &from->m_to));
}

static inline bool sight_heights_cancel(const sight_parts *p, const sight *s)
{
    return sight_dot_cancels(s->speed, p->n, p->d) | sight_dot_cancels(s->over, p->n, p->m) |
           sight_dot_cancels(s->over_to, p->n, p->m_to);
}

static inline sight_parts sight_in_double(const sure_ray *ray, const sight_of *object)
{
    return (sight_parts){
        .d = vec3_from(ray->direction),
        .m = scale_between(*object->from, ray->origin, 1),
        .m_to = scale_between(*object->to, ray->origin, 1),
        .n = object->normal ? vec3_from(*object->normal)
                            : scale_between(*object->from, *object->to, 1),
        .r = object->radius,
    };
}

static inline sight_parts sight_rounded(const twice_sight *s)
{
    return (sight_parts){twice_head(&s->d), twice_head(&s->m), twice_head(&s->m_to),
                         twice_head(&s->n), s->r.head};
}

/* The sight of a shape: <shape>_look takes it in double, <shape>_look_hard with twice the digits.
 * What is looked at again near one is judged again, so that scaling the scene changes nothing. */
#define SIGHT_OF(shape)                                                                            \
    static SIGHT_SELDOM void shape##_look_again(const sure_ray *ray, const sight_of *object,       \
                                                sight_verdict verdict, sight *s)                   \
    {                                                                                              \
        bool wild = verdict == SIGHT_WILD;                                                         \
        twice_sight again = wild ? sight_near_one(ray, object) : sight_in(ray, object, 1);         \
        sight_parts parts = sight_rounded(&again);                                                 \
        if (wild)                                                                                  \
            verdict = shape##_look(&parts, s);                                                     \
        if (verdict == SIGHT_LEVEL)                                                                \
            sight_heights(&again, s);                                                              \
        else if (verdict != SIGHT_CLEAR)                                                           \
            shape##_look_hard(&again, s);                                                          \
        s->shift = again.shift;                                                                    \
    }                                                                                              \
    static inline sight shape##_sight(const sure_ray *ray, const sight_of *object)                 \
    {                                                                                              \
        sight_parts parts = sight_in_double(ray, object);                                          \
        sight s;                                                                                   \
        sight_verdict verdict = shape##_look(&parts, &s);                                          \
        if (verdict != SIGHT_CLEAR)                                                                \
            shape##_look_again(ray, object, verdict, &s);                                          \
        return s;                                                                                  \
    }
#endif

#endif

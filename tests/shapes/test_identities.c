/* SPDX-License-Identifier: MIT */
/* Where a body's polynomial has a second form, both are one polynomial: exactly, in whole numbers.
 * What a plain tier's source derives from the notes is the same one, where nothing is rounded. */
#include "../support/suite.h"

#include "../../src/numbers/exact.h"
#include "../../src/shapes/cone/cone_wall.h"
#include "../../src/shapes/cylinder/cylinder_wall.h"

#define NUMBER exact
#include "../../src/shapes/cone/cone_tmpl.h"
#define NUMBER exact
#include "../../src/shapes/cylinder/cylinder_tmpl.h"
#define NUMBER exact
#include "../../src/shapes/sphere/sphere_tmpl.h"
#include "../../src/shapes/capped/height_filter.h"
#define NUMBER exact
#include "../../src/shapes/capped/height_tmpl.h"

#define NUMBER exact

static exact_arena room;
static exact_context context, *const c = &context;

/* A query in whole numbers, and what the forms are made of: m and d as u and v, too. */
typedef struct {
    sure_ray ray;
    sure_vec3 from, to;
    double radius;
    vector axis, m, d, x_m, x_d; /* x_m = A x m */
    exact r, height, slant, a_m, a_d;
} query;

static query query_about(uint64_t index, sure_vec3 axis, int limit)
{
    query q = {.from = suite_integers(1, 4 * index, limit)};
    context = exact_start(&room);
    q.to = (sure_vec3){q.from.x + axis.x, q.from.y + axis.y, q.from.z + axis.z};
    q.ray = (sure_ray){suite_integers(1, 4 * index + 1, limit),
                       suite_integers(1, 4 * index + 2, limit), 0, INFINITY};
    q.radius = suite_integer(4, index, limit);
    q.axis = vector_between(c, q.from, q.to);
    q.m = vector_between(c, q.from, q.ray.origin);
    q.d = vector_of(c, q.ray.direction);
    q.x_m = vector_cross(c, q.axis, q.m);
    q.x_d = vector_cross(c, q.axis, q.d);
    q.r = exact_of(c, q.radius);
    q.height = vector_square(c, q.axis);
    q.slant = exact_add(c, q.height, exact_square(c, q.r));
    q.a_m = vector_dot(c, q.axis, q.m);
    q.a_d = vector_dot(c, q.axis, q.d);
    return q;
}

static query query_of(int index)
{
    return query_about((uint64_t)index, suite_integers(1, 4 * (uint64_t)index + 3, 1000), 1000);
}

enum { QUERIES = 1000 };
static int which;

/* Of each query, `which`. */
#define QUERY_TEST(name)                                                                           \
    static void check_##name(void);                                                                \
    TEST(test_##name)                                                                              \
    {                                                                                              \
        for (which = 0; which < QUERIES; which++)                                                  \
            check_##name();                                                                        \
    }                                                                                              \
    static void check_##name(void)

static void same(exact x, exact y)
{
    ck_assert_msg(exact_compare(c, x, y) == 0, "of query %d", which);
}

/* [m, d], ... of the cone */
static exact cone_first(const query *q, exact u_v, exact a_u, exact a_v)
{
    return difference_exact(c, cone_form_exact(c, q->height, q->slant, u_v, a_u, a_v));
}

static exact cone_second(const query *q, exact arms, exact a_u, exact a_v)
{
    return difference_exact(c, cone_body_exact(c, q->height, q->r, arms, exact_mul(c, a_u, a_v)));
}

static exact determinant(exact a, exact b, exact last)
{
    return exact_sub(c, exact_square(c, b), exact_mul(c, a, last));
}

QUERY_TEST(cone)
{
    query q = query_of(which);
    exact a = cone_first(&q, vector_square(c, q.d), q.a_d, q.a_d);
    exact b = cone_first(&q, vector_dot(c, q.m, q.d), q.a_m, q.a_d);
    exact last = cone_first(&q, vector_square(c, q.m), q.a_m, q.a_m);
    same(a, cone_second(&q, vector_square(c, q.x_d), q.a_d, q.a_d));
    same(b, cone_second(&q, vector_dot(c, q.x_m, q.x_d), q.a_m, q.a_d));
    same(last, cone_second(&q, vector_square(c, q.x_m), q.a_m, q.a_m));
    vector gradient = cone_gradient_exact(c, q.axis, q.height, q.slant, q.m, q.a_m);
    same(b, vector_dot(c, gradient, q.d));
    two_terms_exact terms = cone_discriminant_exact(c, q.axis, q.height, q.d, q.m, q.r);
    same(determinant(a, b, last),
         exact_mul(c, exact_square(c, q.height), difference_exact(c, terms)));
}

QUERY_TEST(cylinder)
{
    query q = query_of(which);
    exact a = vector_square(c, q.x_d), b = vector_dot(c, q.x_m, q.x_d);
    exact arms = vector_square(c, q.x_m);
    exact last = difference_exact(c, cylinder_body_exact(c, arms, q.height, q.r));
    same(a, cylinder_form_exact(c, q.height, vector_square(c, q.d), q.a_d, q.a_d));
    same(b, cylinder_form_exact(c, q.height, vector_dot(c, q.m, q.d), q.a_m, q.a_d));
    same(arms, cylinder_form_exact(c, q.height, vector_square(c, q.m), q.a_m, q.a_m));
    same(b, vector_dot(c, cylinder_gradient_exact(c, q.axis, q.height, q.m, q.a_m), q.d));
    two_terms_exact terms = cylinder_discriminant_exact(c, a, q.x_d, q.m, q.r);
    same(determinant(a, b, last), exact_mul(c, q.height, difference_exact(c, terms)));
}

QUERY_TEST(sphere)
{
    query q = query_of(which);
    exact a = vector_square(c, q.d), b = vector_dot(c, q.m, q.d);
    exact last = difference_exact(c, sphere_body_exact(c, q.m, q.r));
    same(determinant(a, b, last),
         difference_exact(c, sphere_discriminant_exact(c, a, q.d, q.m, q.r)));
}

/* The slant's two forms, and the end planes' one: m is the point's way from the apex. */
QUERY_TEST(heights)
{
    query q = query_of(which);
    height_query asked = {q.from, q.to, q.ray.origin, q.from, q.radius, true};
    same(height_exact(c, &asked), exact_sub(c, q.slant, vector_square(c, q.m)));
    asked.slant = false;
    same(height_exact(c, &asked), q.a_m);
    asked.end = q.to;
    same(height_exact(c, &asked), exact_sub(c, q.a_m, q.height));
}

/* Axes whose square is a power of two: no quotient of the notes' forms is rounded. */
static query unrounded(int index)
{
    double k = (double)(1 << index % 6);
    const sure_vec3 axes[] = {{k, 0, 0}, {0, -k, 0}, {0, 0, k}, {k, -k, 0}, {0, k, k}, {-k, 0, k}};
    return query_about((uint64_t)index, axes[(index / 6) % 6], 60);
}

static void same_quadratic(quadratic plain, exact scale, exact a, exact b, exact last)
{
    same(exact_mul(c, scale, exact_of(c, plain.a)), a);
    same(exact_mul(c, scale, exact_of(c, plain.half_b)), b);
    same(exact_mul(c, scale, exact_of(c, plain.c)), last);
}

QUERY_TEST(notes_cone)
{
    query q = unrounded(which);
    const sure_cone cone = {q.to, q.from, q.radius};
    cone_line line = cone_line_from(&q.ray, (const double *)&cone);
    same_quadratic(cone_wall_quadratic(&line), exact_square(c, q.height),
                   cone_first(&q, vector_square(c, q.d), q.a_d, q.a_d),
                   cone_first(&q, vector_dot(c, q.m, q.d), q.a_m, q.a_d),
                   cone_first(&q, vector_square(c, q.m), q.a_m, q.a_m));
}

QUERY_TEST(notes_cylinder)
{
    query q = unrounded(which);
    const sure_cylinder cylinder = {q.from, q.to, q.radius};
    cylinder_line line = cylinder_line_from(&q.ray, (const double *)&cylinder);
    exact arms = vector_square(c, q.x_m);
    same_quadratic(cylinder_wall_quadratic(&line), q.height, vector_square(c, q.x_d),
                   vector_dot(c, q.x_m, q.x_d),
                   difference_exact(c, cylinder_body_exact(c, arms, q.height, q.r)));
}

SUITE("identities")

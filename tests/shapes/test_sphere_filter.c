/* The sphere's first stage and polish, held against exact numbers. */
#include "../support/filter_suite.h"
#include "../support/suite.h"

#include "../../src/shapes/sphere/sphere_filter.h"

#include <math.h>
#include <stdio.h>

static sure_vec3 place(const sure_case *c)
{
    return c->object.as.sphere.centre;
}

static double radius(const sure_case *c)
{
    return c->object.as.sphere.radius;
}

static filter_verdict filter(const sure_case *c, filter_interval *found)
{
    return sphere_filter(&c->ray, &c->object.as.sphere, found);
}

static bool polish(const sure_case *c, const filter_end *end, double *t)
{
    return sphere_polish(&c->ray, &c->object.as.sphere, end, t);
}

static polish_step step(const sure_case *c, end_kind at, double t)
{
    return sphere_step(&c->ray, &c->object.as.sphere, at, t);
}

/* a t^2 + 2 b t + c = 0, D = b^2 - a c */
typedef struct {
    mpfr_t a, b, c, discriminant;
} quadratic;

static void quadratic_init(quadratic *q)
{
    mpfr_inits2(FILTER_BITS, q->a, q->b, q->c, q->discriminant, (mpfr_ptr)NULL);
}

static void quadratic_clear(quadratic *q)
{
    mpfr_clears(q->a, q->b, q->c, q->discriminant, (mpfr_ptr)NULL);
}

static void quadratic_of(quadratic *q, const sure_case *c)
{
    filter_triple m, d;
    filter_triple_init(m);
    filter_triple_init(d);
    filter_triple_set(m, c->object.as.sphere.centre, c->ray.origin);
    filter_triple_set(d, (sure_vec3){0, 0, 0}, c->ray.direction);
    filter_triple_dot(q->a, d, d);
    filter_triple_dot(q->b, m, d);
    filter_triple_dot(q->c, m, m);
    mpfr_set_d(q->discriminant, c->object.as.sphere.radius, MPFR_RNDN);
    mpfr_sqr(q->discriminant, q->discriminant, MPFR_RNDN);
    mpfr_sub(q->c, q->c, q->discriminant, MPFR_RNDN);
    mpfr_fmms(q->discriminant, q->b, q->b, q->a, q->c, MPFR_RNDN);
    filter_triple_clear(m);
    filter_triple_clear(d);
}

/* t = (-b -+ sqrt(D)) / a */
static bool truth(const sure_case *c, mpfr_t enter, mpfr_t leave)
{
    quadratic q;
    quadratic_init(&q);
    quadratic_of(&q, c);
    bool exists = mpfr_sgn(q.discriminant) >= 0;
    mpfr_sqrt(q.discriminant, q.discriminant, MPFR_RNDN);
    mpfr_add(enter, q.b, q.discriminant, MPFR_RNDN);
    mpfr_sub(leave, q.discriminant, q.b, MPFR_RNDN);
    mpfr_neg(enter, enter, MPFR_RNDN);
    mpfr_div(enter, enter, q.a, MPFR_RNDN);
    mpfr_div(leave, leave, q.a, MPFR_RNDN);
    quadratic_clear(&q);
    return exists;
}

static const filter_subject subject = {
    SURE_SHAPE_SPHERE, place, radius, filter, polish, step, truth};

START_TEST(test_promises)
{
    filter_promises(&subject);
}
END_TEST

START_TEST(test_steps)
{
    filter_steps(&subject);
}
END_TEST

START_TEST(test_search)
{
    filter_search(&subject);
}
END_TEST

/* D by both ways, and the bounds that decide. */
typedef struct {
    double plain, plain_bound, close, close_bound;
    bool usual;
    double worst, worst_close;
} discriminants;

static void compute(const sure_case *c, void *context)
{
    discriminants *found = context;
    const sure_sphere *sphere = &c->object.as.sphere;
    sphere_terms of = sphere_terms_of(&c->ray, sphere);
    sphere_close_terms close = sphere_close_terms_of(&c->ray, sphere, &of);
    found->usual = sphere_fits(sphere, &of);
    found->plain = of.discriminant;
    found->plain_bound = SURE_SPHERE_DISCRIMINANT_BOUND * of.a * of.size;
    found->close = close.discriminant;
    found->close_bound = SURE_SPHERE_CLOSE_BOUND * sqrt(close.sum) * close.all;
}

static double share(double value, double bound, mpfr_t truth)
{
    mpfr_t off;
    mpfr_init2(off, FILTER_BITS);
    mpfr_sub_d(off, truth, value, MPFR_RNDN);
    mpfr_div_d(off, off, bound, MPFR_RNDN);
    double result = fabs(mpfr_get_d(off, MPFR_RNDA));
    mpfr_clear(off);
    return result;
}

/* The close bound is one for discriminants that exceed it. */
static void judge(const sure_case *c, void *context)
{
    discriminants *found = context;
    quadratic q;
    if (!found->usual)
        return;
    quadratic_init(&q);
    quadratic_of(&q, c);
    double plain = share(found->plain, found->plain_bound, q.discriminant);
    found->worst = fmax(found->worst, plain);
    ck_assert_double_le(plain, 1);
    if (fabs(found->close) > found->close_bound) {
        double close = share(found->close, found->close_bound, q.discriminant);
        found->worst_close = fmax(found->worst_close, close);
        ck_assert_double_le(close, 1);
    }
    quadratic_clear(&q);
}

START_TEST(test_discriminants)
{
    discriminants found = {.worst = 0};
    filter_each(SURE_SHAPE_SPHERE, compute, judge, &found);
    printf("sphere D error/bound %.3f, by d x m %.3f\n", found.worst, found.worst_close);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("sphere filter");
    TCase *all = tcase_create("promises");
    tcase_add_test(all, test_promises);
    tcase_add_test(all, test_search);
    tcase_add_test(all, test_steps);
    tcase_add_test(all, test_discriminants);
    tcase_set_timeout(all, 300);
    suite_add_tcase(suite, all);
    return suite_run(suite);
}

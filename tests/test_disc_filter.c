/* The disc's first stage and polish, held against exact numbers. */
#include "support/filter_suite.h"
#include "support/suite.h"

#include "../src/intersect/disc_filter.h"

static sure_vec3 place(const sure_case *c)
{
    return c->object.as.disc.centre;
}

static double radius(const sure_case *c)
{
    return c->object.as.disc.radius;
}

static filter_verdict filter(const sure_case *c, filter_chord *found)
{
    return disc_filter(&c->ray, &c->object.as.disc, found);
}

static bool polish(const sure_case *c, const filter_end *end, double *t)
{
    return disc_polish(&c->ray, &c->object.as.disc, end, t);
}

static polish_step step(const sure_case *c, point at, double t)
{
    (void)at;
    return crossing_step(&c->ray, &c->object.as.disc.centre, &c->object.as.disc.normal, t);
}

/* Is |t d + m| <= r? Leaves m changed. */
static bool reaches(const sure_case *c, mpfr_t t, filter_triple m, filter_triple d)
{
    mpfr_t r, square;
    mpfr_inits2(FILTER_BITS, r, square, (mpfr_ptr)NULL);
    for (int i = 0; i < 3; i++)
        mpfr_fma(m[i], t, d[i], m[i], MPFR_RNDN);
    filter_triple_dot(square, m, m);
    mpfr_set_d(r, c->object.as.disc.radius, MPFR_RNDN);
    mpfr_sqr(r, r, MPFR_RNDN);
    bool within = mpfr_lessequal_p(square, r);
    mpfr_clears(r, square, (mpfr_ptr)NULL);
    return within;
}

/* t = -N.m / N.d, where that is within the circle. A chord in the disc's plane is no crossing. */
static bool truth(const sure_case *c, mpfr_t enter, mpfr_t leave)
{
    const sure_vec3 zero = {0, 0, 0};
    filter_triple m, d, n;
    filter_triple_init(m);
    filter_triple_init(d);
    filter_triple_init(n);
    filter_triple_set(m, c->object.as.disc.centre, c->ray.origin);
    filter_triple_set(d, zero, c->ray.direction);
    filter_triple_set(n, zero, c->object.as.disc.normal);
    filter_triple_dot(enter, n, m);
    filter_triple_dot(leave, n, d);
    bool crosses = !mpfr_zero_p(leave);
    mpfr_div(enter, enter, leave, MPFR_RNDN);
    mpfr_neg(enter, enter, MPFR_RNDN);
    mpfr_set(leave, enter, MPFR_RNDN);
    bool hits = crosses && reaches(c, enter, m, d);
    filter_triple_clear(m);
    filter_triple_clear(d);
    filter_triple_clear(n);
    return hits;
}

static const filter_subject subject = {SURE_SHAPE_DISC, place, radius, filter, polish, step, truth};

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

int main(void)
{
    Suite *suite = suite_create("disc filter");
    TCase *all = tcase_create("promises");
    tcase_add_test(all, test_promises);
    tcase_add_test(all, test_search);
    tcase_add_test(all, test_steps);
    tcase_set_timeout(all, 300);
    suite_add_tcase(suite, all);
    return suite_run(suite);
}

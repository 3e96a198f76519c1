/* The plane's first stage and polish, held against exact numbers. */
#include "support/filter_suite.h"
#include "support/suite.h"

#include "../src/intersect/plane_filter.h"

static sure_vec3 place(const sure_case *c)
{
    return c->object.as.plane.point;
}

static double no_size(const sure_case *c)
{
    (void)c;
    return 0;
}

static filter_verdict filter(const sure_case *c, filter_chord *found)
{
    return plane_filter(&c->ray, &c->object.as.plane, found);
}

static bool polish(const sure_case *c, const filter_end *end, double *t)
{
    return plane_polish(&c->ray, &c->object.as.plane, end, t);
}

static polish_step step(const sure_case *c, point at, double t)
{
    (void)at;
    return crossing_step(&c->ray, &c->object.as.plane.point, &c->object.as.plane.normal, t);
}

/* t = -N.m / N.d; a line in the plane has no ends. */
static bool truth(const sure_case *c, mpfr_t enter, mpfr_t leave)
{
    const sure_vec3 zero = {0, 0, 0};
    filter_triple m, d, n;
    filter_triple_init(m);
    filter_triple_init(d);
    filter_triple_init(n);
    filter_triple_set(m, c->object.as.plane.point, c->ray.origin);
    filter_triple_set(d, zero, c->ray.direction);
    filter_triple_set(n, zero, c->object.as.plane.normal);
    filter_triple_dot(enter, n, m);
    filter_triple_dot(leave, n, d);
    bool crosses = !mpfr_zero_p(leave);
    mpfr_div(enter, enter, leave, MPFR_RNDN);
    mpfr_neg(enter, enter, MPFR_RNDN);
    mpfr_set(leave, enter, MPFR_RNDN);
    filter_triple_clear(m);
    filter_triple_clear(d);
    filter_triple_clear(n);
    return crosses;
}

static const filter_subject subject = {SURE_SHAPE_PLANE, place, no_size, filter,
                                       polish,           step,  truth};

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
    Suite *suite = suite_create("plane filter");
    TCase *all = tcase_create("promises");
    tcase_add_test(all, test_promises);
    tcase_add_test(all, test_search);
    tcase_add_test(all, test_steps);
    tcase_set_timeout(all, 300);
    suite_add_tcase(suite, all);
    return suite_run(suite);
}

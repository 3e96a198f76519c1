/* The cone's first stage and polish, held against exact numbers. */
#include "../support/axial_truth.h"
#include "../support/suite.h"

#include "../../src/shapes/cone/cone_filter.h"

#include <math.h>

static sure_vec3 place(const sure_case *c)
{
    return c->object.as.cone.base;
}

static double size(const sure_case *c)
{
    const sure_cone *cone = &c->object.as.cone;
    vector_f64 axis = vector_between_f64(NULL, cone->base, cone->apex);
    return cone->radius + sqrt(vector_dot_f64(NULL, axis, axis));
}

static filter_verdict filter(const sure_case *c, filter_interval *found)
{
    return cone_filter(&c->ray, &c->object.as.cone, found);
}

static bool polish(const sure_case *c, const filter_end *end, double *t)
{
    return cone_polish(&c->ray, &c->object.as.cone, end, t);
}

static polish_step step(const sure_case *c, end_kind at, double t)
{
    return cone_step(&c->ray, &c->object.as.cone, at, t);
}

static bool truth(const sure_case *c, mpfr_t enter, mpfr_t leave)
{
    axial_truth found;
    axial_truth_init(&found);
    bool meets = axial_truth_of(c, &found);
    mpfr_set(enter, found.ends[0], MPFR_RNDN);
    mpfr_set(leave, found.ends[1], MPFR_RNDN);
    axial_truth_clear(&found);
    return meets;
}

static const filter_subject subject = {SURE_SHAPE_CONE, place, size, filter, polish, step, truth};

static bool terms(const sure_case *c, double *value, double *certain)
{
    cone_terms of = cone_terms_of(&c->ray, &c->object.as.cone);
    *value = of.inner - of.outer;
    *certain = of.certain;
    return *value * *value > of.certain && cone_fits(&c->object.as.cone, &of);
}

START_TEST(test_promises)
{
    filter_promises(&subject);
}
END_TEST

START_TEST(test_search)
{
    filter_search(&subject);
}
END_TEST

START_TEST(test_steps)
{
    axial_steps(SURE_SHAPE_CONE, step);
}
END_TEST

/* The points that the ends are said to be, which their numbers do not show. */
START_TEST(test_points)
{
    axial_points(&subject);
}
END_TEST

START_TEST(test_edges)
{
    axial_edges(&subject);
}
END_TEST

START_TEST(test_walls)
{
    axial_search(&subject);
}
END_TEST

START_TEST(test_discriminants)
{
    axial_discriminants(SURE_SHAPE_CONE, terms);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cone filter");
    TCase *all = tcase_create("promises");
    tcase_add_test(all, test_promises);
    tcase_add_test(all, test_search);
    tcase_add_test(all, test_steps);
    tcase_add_test(all, test_points);
    tcase_add_test(all, test_edges);
    tcase_add_test(all, test_walls);
    tcase_add_test(all, test_discriminants);
    tcase_set_timeout(all, 300);
    suite_add_tcase(suite, all);
    return suite_run(suite);
}

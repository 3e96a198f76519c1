/* The cylinder's first stage and polish, held against exact numbers. */
#include "../support/axial_truth.h"
#include "../support/suite.h"

#include "../../src/shapes/cylinder/cylinder_filter.h"

#include <math.h>

static sure_vec3 place(const sure_case *c)
{
    return c->object.as.cylinder.base;
}

static double size(const sure_case *c)
{
    const sure_cylinder *cylinder = &c->object.as.cylinder;
    vector_f64 axis = vector_between_f64(NULL, cylinder->base, cylinder->top);
    return cylinder->radius + sqrt(vector_dot_f64(NULL, axis, axis));
}

static filter_verdict filter(const sure_case *c, filter_interval *found)
{
    return cylinder_filter(&c->ray, &c->object.as.cylinder, found);
}

static bool polish(const sure_case *c, const filter_end *end, double *t)
{
    return cylinder_polish(&c->ray, &c->object.as.cylinder, end, t);
}

static polish_step step(const sure_case *c, end_kind at, double t)
{
    return cylinder_step(&c->ray, &c->object.as.cylinder, at, t);
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

static const filter_subject subject = {
    SURE_SHAPE_CYLINDER, place, size, filter, polish, step, truth};

static bool terms(const sure_case *c, double *value, double *certain)
{
    cylinder_terms of = cylinder_terms_of(&c->ray, &c->object.as.cylinder);
    *value = of.inner - of.outer;
    *certain = of.certain;
    return *value * *value > of.certain && cylinder_fits(&c->object.as.cylinder, &of);
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
    axial_steps(SURE_SHAPE_CYLINDER, step);
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
    axial_discriminants(SURE_SHAPE_CYLINDER, terms);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cylinder filter");
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

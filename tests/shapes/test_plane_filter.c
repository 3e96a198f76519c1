/* The plane's first two stages and polish, held against exact numbers. */
#include "../support/filter_suite.h"
#include "../support/flat_suite.h"
#include "../support/suite.h"

#include "../../src/shapes/plane/plane_close.h"

static sure_vec3 place(const sure_case *c)
{
    return c->object.as.plane.point;
}

static double no_size(const sure_case *c)
{
    (void)c;
    return 0;
}

/* Of the line alone, wherever the ray starts. */
static filter_verdict line_filter(const sure_case *c, filter_interval *found)
{
    const sure_plane *plane = &c->object.as.plane;
    flat_terms of = flat_terms_of(&c->ray, &plane->point, &plane->normal);
    return flat_in_range(&of) ? flat_crossing(&of, 0, found) : FILTER_UNCERTAIN;
}

static bool polish(const sure_case *c, const filter_end *end, double *t)
{
    return plane_polish(&c->ray, &c->object.as.plane, end, t);
}

static polish_step step(const sure_case *c, end_kind at, double t)
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

static const filter_subject subject = {SURE_SHAPE_PLANE, place, no_size, line_filter,
                                       polish,           step,  truth};

static sure_vec3 normal(const sure_case *c)
{
    return c->object.as.plane.normal;
}

static double no_rim(const sure_case *c)
{
    (void)c;
    return INFINITY;
}

static filter_verdict filter(const sure_case *c, filter_interval *found)
{
    return plane_filter(&c->ray, &c->object.as.plane, found);
}

static filter_verdict closely(const sure_case *c, t_wanted wanted, sure_hit *hit)
{
    return plane_close(&c->ray, &c->object.as.plane, wanted, hit);
}

static const flat_subject flat = {SURE_SHAPE_PLANE, place, normal, no_rim, filter, closely};

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

START_TEST(test_hits)
{
    flat_promises(&flat);
}
END_TEST

/* Planes that are crossed at about t_min, to within roundings. */
START_TEST(test_behind)
{
    flat_near(&flat);
}
END_TEST

static double whole(uint64_t stream, uint64_t i, int bits)
{
    return floor(suite_double(stream, i, 0) * power_of_two(bits));
}

/* v.(v x u) = 0, in whole numbers of up to 52 and 104 digits; with one component off by one it is
 * not. */
START_TEST(test_vanishing)
{
    enum { DRAWN = 20000 };
    int vanish = 0;
    for (uint64_t i = 0; i < DRAWN; i++) {
        sure_vec3 v = {whole(1, i, 26), whole(2, i, 26), whole(3, i, 26)};
        sure_vec3 u = {whole(4, i, 24), whole(5, i, 24), whole(6, i, 24)};
        sure_vec3 w = {v.y * u.z - v.z * u.y, v.z * u.x - v.x * u.z, v.x * u.y - v.y * u.x};
        double far = power_of_two((int)(suite_bits(7, i) % 26));
        v = (sure_vec3){v.x * far, v.y * far, v.z * far};
        vector_dd across = vector_of_dd(NULL, w);
        vanish += dot_vanishes(&v, &across);
        across.x.head += v.x != 0;
        across.y.head += v.x == 0;
        ck_assert(!dot_vanishes(&v, &across) || (v.x == 0 && v.y == 0));
        across = vector_of_dd(NULL, w);
        across.z.tail = 0x1p-40;
        ck_assert(!dot_vanishes(&v, &across));
    }
    ck_assert_int_eq(vanish, DRAWN);
}
END_TEST

/* Heads that cancel and tails that do not, and the other way round. */
START_TEST(test_left_out)
{
    const struct {
        double heads[4], tails[4];
        bool zero;
    } sums[] = {{{0x1p60, 1, -0x1p60, 0}, {0, 0, 0, 0}, false},
                {{0x1p60, 1, -0x1p60, -1}, {0, 0, 0, 0}, true},
                {{0, 0, 0, 0}, {0x1p60, 0x1p-60, -0x1p60, 0}, false},
                {{0, 0, 0, 0}, {0x1p60, -0x1p60, 0x1p60, 0x1p-60}, false},
                {{-0x1p60, 0, 0, 0}, {0x1p60, 0, 0x1p-60, 0}, false},
                {{0x1p60, 1, -0x1p60, -1}, {0, 0x1p-9, 0, 0}, false},
                {{1, 0x1p-60, -1, 0}, {-0x1p-60, 0, 0, 0}, true}};
    for (int i = 0; i < 7; i++)
        ck_assert_int_eq(sum_vanishes(sums[i].heads, sums[i].tails), sums[i].zero);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("plane filter");
    TCase *all = tcase_create("promises");
    tcase_add_test(all, test_promises);
    tcase_add_test(all, test_search);
    tcase_add_test(all, test_steps);
    tcase_add_test(all, test_hits);
    tcase_add_test(all, test_behind);
    tcase_add_test(all, test_vanishing);
    tcase_add_test(all, test_left_out);
    tcase_set_timeout(all, 300);
    suite_add_tcase(suite, all);
    return suite_run(suite);
}

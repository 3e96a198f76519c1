/* The stable tier's promises (docs/proofs/stable.md), against exact answers in every regime. */
#include "bisection_result.h"
#include "regimes.h"
#include "suite.h"

#include <math.h>
#include <mpfr.h>

enum { CASES = 400 };

/* Are all numbers of the case 0 or such that lengths can be computed in double? */
static bool measurable(const sure_case *question)
{
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(question, numbers);
    for (int i = 0; i < case_numbers(question->object.shape); i++) {
        double size = fabs(numbers[i]);
        if (size != 0 && size != INFINITY && !(size > 0x1p-200 && size < 0x1p200))
            return false;
    }
    return true;
}

static double length(sure_vec3 v)
{
    return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

static double dot(sure_vec3 v, sure_vec3 w)
{
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

static double radius_of(const sure_object *object)
{
    return object->shape == SURE_SHAPE_SPHERE ? object->as.sphere.radius
           : object->shape == SURE_SHAPE_DISC ? object->as.disc.radius
                                              : 0;
}

static double distance_from(const sure_ray *ray, const sure_object *object)
{
    sure_vec3 o = ray->origin;
    sure_vec3 at = object->shape == SURE_SHAPE_SPHERE ? object->as.sphere.centre
                   : object->shape == SURE_SHAPE_DISC ? object->as.disc.centre
                                                      : object->as.plane.point;
    return length((sure_vec3){o.x - at.x, o.y - at.y, o.z - at.z});
}

/* |N.d| / |d|, of a sphere from its chord: it is the same at both ends. */
static double steepness(const sure_case *question, const bisection_result *truth)
{
    const sure_object *object = &question->object;
    sure_vec3 d = question->ray.direction;
    const sure_interval *chord = &truth->interval;
    if (object->shape == SURE_SHAPE_SPHERE)
        return (chord->t_leave - chord->t_enter) * length(d) / (2 * object->as.sphere.radius);
    return fabs(dot(truth->normal, d)) / length(d);
}

/* Is t within the bound of the end t* of the chord? */
static bool kept(const sure_case *question, double steep, double t, double exact)
{
    double d = length(question->ray.direction);
    double reach = distance_from(&question->ray, &question->object) + fabs(exact) * d +
                   radius_of(&question->object);
    return fabs(t - exact) * steep * d <= SURE_STABLE_T_ERROR * reach;
}

static bool promised(const sure_case *question, const bisection_result *truth)
{
    const sure_object *object = &question->object;
    const sure_interval *chord = &truth->interval;
    if (truth->status != SURE_HIT || !measurable(question) || !isfinite(chord->t_enter))
        return false;
    if (object->shape == SURE_SHAPE_SPHERE &&
        !(object->as.sphere.radius >=
          SURE_STABLE_GRAZING * SURE_STABLE_GRAZING * distance_from(&question->ray, object)))
        return false;
    return steepness(question, truth) >= SURE_STABLE_GRAZING;
}

static void check_chord(const sure_case *question, uint64_t *checked)
{
    sure_case whole = *question;
    whole.ray.t_min = 0;
    whole.ray.t_max = INFINITY;
    bisection_result truth = bisection_of(&whole);
    if (!promised(&whole, &truth))
        return;
    sure_interval given;
    double steep = steepness(&whole, &truth);
    sure_status status = sure_object_interval(&whole.ray, &whole.object, SURE_TIER_STABLE, &given);
    if (status == SURE_MISS && whole.object.shape == SURE_SHAPE_DISC)
        return; /* nothing is promised of its rim */
    bool right = status == SURE_HIT && kept(&whole, steep, given.t_enter, truth.interval.t_enter) &&
                 kept(&whole, steep, given.t_leave, truth.interval.t_leave);
    ++*checked;
    char line[CASE_LINE_MAX];
    case_print(&whole, line);
    if (!right)
        ck_abort_msg("beyond SURE_STABLE_T_ERROR: %s", line);
}

START_TEST(test_t_error)
{
    sure_shape shape = (sure_shape)_i;
    uint64_t checked = 0;
    for (regime r = 0; r < REGIMES; r++) {
        for (uint64_t i = 0; regime_applies(shape, r) && i < CASES; i++) {
            sure_case question = regime_case(shape, r, 1, i);
            if (sure_object_check(&question.ray, &question.object) == SURE_FIELD_NONE)
                check_chord(&question, &checked);
        }
    }
    ck_assert_uint_ge(checked, CASES);
}
END_TEST

/* Every product and difference of doubles fits. */
enum { EXACT_BITS = 4400, QUADRATICS = 20000 };

/* (-h + sign sqrt(h^2 - a c)) / a, rounded to double; the exact sign of h^2 - a c is returned. */
static int exact_root(double a, double h, double c, int sign, double *root)
{
    mpfr_t quarter, other, top;
    mpfr_inits2(EXACT_BITS, quarter, other, top, (mpfr_ptr)0);
    mpfr_set_d(quarter, h, MPFR_RNDN);
    mpfr_sqr(quarter, quarter, MPFR_RNDN);
    mpfr_set_d(other, a, MPFR_RNDN);
    mpfr_mul_d(other, other, c, MPFR_RNDN);
    mpfr_sub(quarter, quarter, other, MPFR_RNDN);
    int count = mpfr_sgn(quarter);
    if (count >= 0) {
        mpfr_sqrt(top, quarter, MPFR_RNDN);
        mpfr_mul_si(top, top, sign, MPFR_RNDN);
        mpfr_sub_d(top, top, h, MPFR_RNDN);
        mpfr_div_d(top, top, a, MPFR_RNDN);
        *root = mpfr_get_d(top, MPFR_RNDN);
    }
    mpfr_clears(quarter, other, top, (mpfr_ptr)0);
    return count;
}

/* Is x at most `ulps` steps from the correctly rounded root, which is half a step from the root?
 * A step down across a power of two is half an ulp: such steps are counted twice. */
static bool ulps_away(double x, double root, int ulps)
{
    for (int i = 0; i < ulps; i++) {
        if (x == root)
            return true;
        root = nextafter(root, x);
    }
    return x == root;
}

/* Coefficients of like size, of any size, and such that D/4 nearly or wholly cancels. */
static void draw_quadratic(uint64_t i, double *a, double *h, double *c)
{
    int spread = i % 2 == 0 ? 3 : 400;
    *a = suite_double(11, i, spread);
    *h = suite_double(12, i, spread);
    *c = suite_double(13, i, spread);
    if (i % 8 >= 4)
        *c = *h / *a * *h;
    if (i % 16 == 15) { /* a perfect square, as large as doubles hold */
        double p = suite_integer(14, i, 1 << 25), q = suite_integer(15, i, 1 << 25);
        *a = p * p;
        *h = ldexp(p * q, suite_integer(16, i, 300));
        *c = *h / p * (*h / p);
    }
}

START_TEST(test_root_ulps)
{
    uint64_t counts[3] = {0, 0, 0};
    for (uint64_t i = 0; i < QUADRATICS; i++) {
        double a, h, c, low = 0, high = 0, roots[2] = {0, 0};
        draw_quadratic(i, &a, &h, &c);
        if (a == 0 || !isfinite(c))
            continue;
        int sign = a > 0 ? 1 : -1, count = exact_root(a, h, c, -sign, &low);
        (void)exact_root(a, h, c, sign, &high);
        counts[count + 1]++;
        sure_roots found = sure_quadratic_stable(a, h, c, roots);
        bool right = found == (count < 0 ? SURE_ROOTS_NONE : SURE_ROOTS_TWO) &&
                     (count < 0 || (ulps_away(roots[0], low, SURE_STABLE_ROOT_ULPS) &&
                                    ulps_away(roots[1], high, SURE_STABLE_ROOT_ULPS)));
        if (!right)
            ck_abort_msg("a %a, h %a, c %a: %a, %a, not %a, %a", a, h, c, roots[0], roots[1], low,
                         high);
    }
    ck_assert(counts[0] > QUADRATICS / 8 && counts[1] > 0 && counts[2] > QUADRATICS / 8);
}
END_TEST

static sure_vec3 scaled(sure_vec3 v, int k)
{
    return (sure_vec3){ldexp(v.x, k), ldexp(v.y, k), ldexp(v.z, k)};
}

static sure_vec3 drawn(uint64_t stream, uint64_t i)
{
    return (sure_vec3){suite_double(stream, i, 2), suite_double(stream + 1, i, 2),
                       suite_double(stream + 2, i, 2)};
}

/* Lengths of any size: what a power of two does to the arguments it does to the result, exactly. */
START_TEST(test_any_size)
{
    static const int powers[] = {-600, -300, 300, 600, 1000};
    for (uint64_t i = 0; i < 1000; i++) {
        int k = powers[i % 5], j = powers[i / 5 % 5];
        sure_vec3 v = drawn(21, i), n = drawn(24, i), p = drawn(27, i);
        ck_vector_same(sure_project_stable(scaled(v, k), scaled(n, j)),
                       scaled(sure_project_stable(v, n), k));
        ck_vector_same(sure_reflect_stable(scaled(v, k), scaled(n, j)),
                       scaled(sure_reflect_stable(v, n), k));
        ck_double_same(sure_light_intensity_stable(scaled(p, k), scaled(n, j), scaled(v, k)),
                       sure_light_intensity_stable(p, n, v));
        sure_cylinder tube = {p, v, 1}, large_tube = {scaled(p, k), scaled(v, k), ldexp(1, k)};
        ck_vector_same(sure_cylinder_wall_normal_stable(scaled(n, k), &large_tube),
                       sure_cylinder_wall_normal_stable(n, &tube));
        ck_assert_int_eq(sure_cylinder_height_stable(scaled(n, k), &large_tube),
                         sure_cylinder_height_stable(n, &tube));
        sure_cone cone = {p, v, 1}, large_cone = {scaled(p, k), scaled(v, k), ldexp(1, k)};
        ck_vector_same(sure_cone_wall_normal_stable(scaled(n, k), &large_cone),
                       sure_cone_wall_normal_stable(n, &cone));
        ck_assert_int_eq(sure_cone_height_stable(scaled(n, k), &large_cone),
                         sure_cone_height_stable(n, &cone));
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("stable");
    TCase *bounds = tcase_create("bounds");
    tcase_set_timeout(bounds, 240);
    tcase_add_loop_test(bounds, test_t_error, SURE_SHAPE_PLANE, SURE_SHAPE_SPHERE + 1);
    tcase_add_test(bounds, test_root_ulps);
    tcase_add_test(bounds, test_any_size);
    suite_add_tcase(suite, bounds);
    return suite_run(suite);
}

#include "refraction_truth.h"

#include <surehit/bounds.h>

#include "tiers.h"
#include "true_hit.h"

#include <math.h>

enum { BITS = 500 };

static void set(true_vector out, sure_vec3 v)
{
    true_vector_between(out, (sure_vec3){0, 0, 0}, v);
}

static void cross(true_vector out, true_vector v, true_vector w)
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        mpfr_fmms(out[i], v[j], w[k], v[k], w[j], MPFR_RNDN);
    }
}

static void set_length(mpfr_t out, true_vector v)
{
    true_dot(out, v, v);
    mpfr_sqrt(out, out, MPFR_RNDN);
}

/* Its length is taken out of v, but of 0. */
static void make_unit(true_vector v, mpfr_t length)
{
    set_length(length, v);
    for (int i = 0; i < 3 && !mpfr_zero_p(length); i++)
        mpfr_div(v[i], v[i], length, MPFR_RNDN);
}

/* v + k w */
static void move(true_vector v, mpfr_t k, true_vector w)
{
    for (int i = 0; i < 3; i++)
        mpfr_fma(v[i], k, w[i], v[i], MPFR_RNDN);
}

static void subtract(true_vector v, const true_vector w)
{
    for (int i = 0; i < 3; i++)
        mpfr_sub(v[i], v[i], w[i], MPFR_RNDN);
}

void refraction_truth_init(refraction_truth *truth)
{
    true_vector_init(truth->direction, BITS);
    mpfr_inits2(BITS, truth->length, truth->left, truth->share, (mpfr_ptr)0);
}

void refraction_truth_clear(refraction_truth *truth)
{
    true_vector_clear(truth->direction);
    mpfr_clears(truth->length, truth->left, truth->share, (mpfr_ptr)0);
}

/* ((ratio - 1) / (ratio + 1))^2 */
static void share_along_normal(mpfr_t share, double ratio)
{
    mpfr_t sum;
    mpfr_init2(sum, BITS);
    mpfr_set_d(sum, ratio, MPFR_RNDN);
    mpfr_sub_ui(share, sum, 1, MPFR_RNDN);
    mpfr_add_ui(sum, sum, 1, MPFR_RNDN);
    mpfr_div(share, share, sum, MPFR_RNDN);
    mpfr_sqr(share, share, MPFR_RNDN);
    mpfr_clear(sum);
}

/* Transmitted are sin 2i sin 2t / sin^2(i + t), and that over cos^2(i - t). */
static void share_by_angles(mpfr_t share, mpfr_t i, mpfr_t t)
{
    mpfr_t across, in, x;
    mpfr_inits2(BITS, across, in, x, (mpfr_ptr)0);
    mpfr_mul_ui(x, i, 2, MPFR_RNDN);
    mpfr_sin(across, x, MPFR_RNDN);
    mpfr_mul_ui(x, t, 2, MPFR_RNDN);
    mpfr_sin(x, x, MPFR_RNDN);
    mpfr_mul(across, across, x, MPFR_RNDN);
    mpfr_add(x, i, t, MPFR_RNDN);
    mpfr_sin(x, x, MPFR_RNDN);
    mpfr_sqr(x, x, MPFR_RNDN);
    mpfr_div(across, across, x, MPFR_RNDN);
    mpfr_sub(x, i, t, MPFR_RNDN);
    mpfr_cos(x, x, MPFR_RNDN);
    mpfr_sqr(x, x, MPFR_RNDN);
    mpfr_div(in, across, x, MPFR_RNDN);
    mpfr_add(x, across, in, MPFR_RNDN);
    mpfr_div_ui(x, x, 2, MPFR_RNDN);
    mpfr_ui_sub(share, 1, x, MPFR_RNDN);
    mpfr_clears(across, in, x, (mpfr_ptr)0);
}

/* |d| (sin(t) along - cos(t) n), both of length 1. */
static void turn_from_normal(refraction_truth *truth, mpfr_t t, true_vector along, true_vector n)
{
    mpfr_t part;
    mpfr_init2(part, BITS);
    set(truth->direction, (sure_vec3){0, 0, 0});
    mpfr_sin(part, t, MPFR_RNDN);
    mpfr_mul(part, part, truth->length, MPFR_RNDN);
    move(truth->direction, part, along);
    mpfr_cos(part, t, MPFR_RNDN);
    truth->refracted = mpfr_get_d(part, MPFR_RNDN);
    mpfr_mul(part, part, truth->length, MPFR_RNDN);
    mpfr_neg(part, part, MPFR_RNDN);
    move(truth->direction, part, n);
    mpfr_clear(part);
}

/* The angle of d with the line of n; d is left as the unit vector along the surface. */
static void angle_of(mpfr_t i, true_vector d, true_vector n)
{
    mpfr_t height;
    mpfr_init2(height, BITS);
    true_dot(height, n, d);
    mpfr_neg(height, height, MPFR_RNDN);
    move(d, height, n);
    make_unit(d, i);
    mpfr_abs(height, height, MPFR_RNDN);
    mpfr_atan2(i, i, height, MPFR_RNDN);
    mpfr_clear(height);
}

sure_status refraction_truth_of(refraction_truth *truth, const refraction_question *q)
{
    true_vector d, n;
    mpfr_t i, t;
    true_vector_init(d, BITS);
    true_vector_init(n, BITS);
    mpfr_inits2(BITS, i, t, (mpfr_ptr)0);
    set(d, q->d);
    set(n, q->n);
    set_length(truth->length, d);
    make_unit(n, i);
    angle_of(i, d, n);
    mpfr_cos(t, i, MPFR_RNDN);
    truth->cosine = mpfr_get_d(t, MPFR_RNDN);
    mpfr_sin(t, i, MPFR_RNDN);
    mpfr_mul_d(t, t, q->ratio, MPFR_RNDN);
    mpfr_sqr(truth->left, t, MPFR_RNDN);
    mpfr_ui_sub(truth->left, 1, truth->left, MPFR_RNDN);
    sure_status status = mpfr_sgn(truth->left) >= 0 ? SURE_HIT : SURE_MISS;
    if (status == SURE_HIT) {
        mpfr_asin(t, t, MPFR_RNDN);
        turn_from_normal(truth, t, d, n);
        if (mpfr_zero_p(i))
            share_along_normal(truth->share, q->ratio);
        else
            share_by_angles(truth->share, i, t);
    }
    mpfr_clears(i, t, (mpfr_ptr)0);
    true_vector_clear(n);
    true_vector_clear(d);
    return status;
}

/* |x| / |d|, rounded up */
static double share_of_length(mpfr_t x, const refraction_truth *truth)
{
    mpfr_div(x, x, truth->length, MPFR_RNDN);
    return fabs(mpfr_get_d(x, MPFR_RNDA));
}

double refraction_direction_off(const refraction_truth *truth, sure_vec3 t)
{
    true_vector off;
    mpfr_t length;
    true_vector_init(off, BITS);
    mpfr_init2(length, BITS);
    set(off, t);
    subtract(off, truth->direction);
    set_length(length, off);
    double found = share_of_length(length, truth);
    mpfr_clear(length);
    true_vector_clear(off);
    return found;
}

/* |N x t - ratio N x d| = |N x (t - ratio d)| */
static void snell(mpfr_t out, const refraction_question *q, true_vector t, true_vector n)
{
    true_vector d, turn;
    true_vector_init(d, BITS);
    true_vector_init(turn, BITS);
    set(d, q->d);
    mpfr_set_d(out, -q->ratio, MPFR_RNDN);
    move(t, out, d);
    cross(turn, n, t);
    set_length(out, turn);
    true_vector_clear(turn);
    true_vector_clear(d);
}

double refraction_snell_off(const refraction_truth *truth, const refraction_question *q,
                            sure_vec3 t)
{
    true_vector way, n;
    mpfr_t x;
    true_vector_init(way, BITS);
    true_vector_init(n, BITS);
    mpfr_init2(x, BITS);
    set(way, t);
    set(n, q->n);
    make_unit(n, x);
    true_dot(x, n, way);
    double beyond = mpfr_sgn(x) > 0 ? share_of_length(x, truth) : 0;
    set_length(x, way);
    mpfr_sub(x, x, truth->length, MPFR_RNDN);
    double longer = share_of_length(x, truth);
    snell(x, q, way, n);
    double turned = share_of_length(x, truth);
    mpfr_clear(x);
    true_vector_clear(n);
    true_vector_clear(way);
    return fmax(turned, fmax(longer, beyond));
}

double refraction_share_off(const refraction_truth *truth, double share)
{
    mpfr_t off;
    mpfr_init2(off, BITS);
    mpfr_sub_d(off, truth->share, share, MPFR_RNDN);
    double found = fabs(mpfr_get_d(off, MPFR_RNDA));
    mpfr_clear(off);
    return found;
}

static sure_status (*const refract[])(sure_vec3, sure_vec3, double, sure_vec3 *) = {
    sure_refract_float32, sure_refract_textbook, sure_refract_stable};
static double (*const fresnel[])(sure_vec3, sure_vec3, double) = {
    sure_refract_fresnel_float32, sure_refract_fresnel_textbook, sure_refract_fresnel_stable};

/* Are refraction and total reflection told from one another this far from the critical angle? */
static bool is_told(sure_tier tier, const refraction_truth *truth, double ratio)
{
    double step = SURE_REFRACT_ULPS * (double)unit(tier),
           left = fabs(mpfr_get_d(truth->left, MPFR_RNDZ));
    return left > (tier == SURE_TIER_STABLE ? step * step : step * fmax(1, ratio));
}

static double direction_bound(sure_tier tier, const refraction_truth *truth, double ratio)
{
    double bound = SURE_REFRACT_ULPS * (double)unit(tier);
    return tier == SURE_TIER_STABLE ? bound : bound * fmax(1, ratio) / truth->refracted;
}

/* Stable promises nothing close to the critical angle, but what is possible. */
static double share_bound(sure_tier tier, const refraction_truth *truth, double ratio)
{
    double bound = SURE_FRESNEL_ULPS * (double)unit(tier);
    if (tier != SURE_TIER_STABLE)
        return bound * (1 + ratio * ratio) / (truth->cosine * truth->refracted);
    return truth->refracted >= SURE_STABLE_GRAZING ? bound * mpfr_get_d(truth->share, MPFR_RNDN)
                                                   : 1;
}

static const char *answer_broken(sure_tier tier, const refraction_question *q,
                                 const refraction_truth *truth, sure_vec3 t, double share)
{
    double bound = direction_bound(tier, truth, q->ratio);
    if (!(refraction_direction_off(truth, t) <= bound))
        return "SURE_REFRACT_ULPS of the direction";
    if (!(refraction_snell_off(truth, q, t) <= bound))
        return "Law 5: Snell's law";
    if (!(refraction_share_off(truth, share) <= share_bound(tier, truth, q->ratio)))
        return "SURE_FRESNEL_ULPS of the share";
    return NULL;
}

static const char *truth_broken(sure_tier tier, const refraction_question *q,
                                refraction_truth *truth, refraction_counts *count)
{
    sure_vec3 t = {5, 6, 7};
    sure_status expected = refraction_truth_of(truth, q);
    sure_status status = refract[tier](q->d, q->n, q->ratio, &t);
    double share = fresnel[tier](q->d, q->n, q->ratio);
    if (status == SURE_MISS && !(share == 1 && t.x == 5 && t.y == 6 && t.z == 7))
        return "Law 6: total reflection";
    if (status != expected) {
        count->mistaken++;
        return is_told(tier, truth, q->ratio) ? "total reflection is not told" : NULL;
    }
    count->refracted += status == SURE_HIT;
    count->total += status == SURE_MISS;
    return status == SURE_HIT ? answer_broken(tier, q, truth, t, share) : NULL;
}

const char *refraction_broken(sure_tier tier, const refraction_question *q,
                              refraction_counts *count)
{
    refraction_truth truth;
    if (!(q->ratio >= SURE_INDEX_RATIO_LEAST && q->ratio <= 1 / SURE_INDEX_RATIO_LEAST) ||
        q->ratio == 1)
        return NULL;
    refraction_truth_init(&truth);
    const char *broken = truth_broken(tier, q, &truth, count);
    refraction_truth_clear(&truth);
    return broken;
}

/* Stable takes any length. The other tiers' numbers are 0 or within these powers of two. */
static bool is_moderate(sure_tier tier, sure_vec3 v)
{
    int most = tier == SURE_TIER_FLOAT32 ? 12 : tier == SURE_TIER_TEXTBOOK ? 100 : 1000;
    const double numbers[] = {v.x, v.y, v.z};
    for (int i = 0; i < 3; i++) {
        double x = fabs(numbers[i]);
        if (x != 0 && !(x > ldexp(1, -most) && x < ldexp(1, most)))
            return false;
    }
    return true;
}

bool refraction_is_moderate(sure_tier tier, const refraction_question *q)
{
    return is_moderate(tier, q->d) && is_moderate(tier, q->n);
}

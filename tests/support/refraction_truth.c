/* SPDX-License-Identifier: MIT */
#include "refraction_truth.h"

#include <surehit/bounds.h>

#include "tiers.h"
#include "true_hit.h"

enum { BITS = 500 };

/* What is known of a question, and numbers to compute it with. */
typedef struct {
    true_vector d, n;         /* as given, and of length 1 */
    true_vector along;        /* of length 1 or 0: what of d is along the surface */
    true_vector direction;    /* refracted, of length |d| */
    mpfr_t length;            /* |d| */
    mpfr_t i, t;              /* the angles with the normal's line */
    mpfr_t left;              /* 1 - (ratio sin i)^2: what is left for cos^2 t */
    mpfr_t share;             /* reflected */
    double cosine, refracted; /* cos i, cos t */
    true_vector v, w;
    mpfr_t x, y;
} refraction_truth;

static void init(refraction_truth *r)
{
    true_vector *const vectors[] = {&r->d, &r->n, &r->along, &r->direction, &r->v, &r->w};
    for (int k = 0; k < 6; k++)
        true_vector_init(*vectors[k], BITS);
    mpfr_inits2(BITS, r->length, r->i, r->t, r->left, r->share, r->x, r->y, (mpfr_ptr)0);
}

static void clear(refraction_truth *r)
{
    true_vector *const vectors[] = {&r->d, &r->n, &r->along, &r->direction, &r->v, &r->w};
    for (int k = 0; k < 6; k++)
        true_vector_clear(*vectors[k]);
    mpfr_clears(r->length, r->i, r->t, r->left, r->share, r->x, r->y, (mpfr_ptr)0);
}

static void set(true_vector out, sure_vec3 v)
{
    true_vector_between(out, (sure_vec3){0, 0, 0}, v);
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
    for (int k = 0; k < 3 && !mpfr_zero_p(length); k++)
        mpfr_div(v[k], v[k], length, MPFR_RNDN);
}

/* v + k w */
static void move(true_vector v, mpfr_t k, true_vector w)
{
    for (int i = 0; i < 3; i++)
        mpfr_fma(v[i], k, w[i], v[i], MPFR_RNDN);
}

/* ((ratio - 1) / (ratio + 1))^2 */
static void set_share_along_normal(refraction_truth *r, double ratio)
{
    mpfr_set_d(r->x, ratio, MPFR_RNDN);
    mpfr_sub_ui(r->share, r->x, 1, MPFR_RNDN);
    mpfr_add_ui(r->x, r->x, 1, MPFR_RNDN);
    mpfr_div(r->share, r->share, r->x, MPFR_RNDN);
    mpfr_sqr(r->share, r->share, MPFR_RNDN);
}

/* Transmitted are sin 2i sin 2t / sin^2(i + t), and that over cos^2(i - t). */
static void set_share_by_angles(refraction_truth *r)
{
    mpfr_mul_ui(r->x, r->i, 2, MPFR_RNDN);
    mpfr_sin(r->y, r->x, MPFR_RNDN);
    mpfr_mul_ui(r->x, r->t, 2, MPFR_RNDN);
    mpfr_sin(r->x, r->x, MPFR_RNDN);
    mpfr_mul(r->y, r->y, r->x, MPFR_RNDN);
    mpfr_add(r->x, r->i, r->t, MPFR_RNDN);
    mpfr_sin(r->x, r->x, MPFR_RNDN);
    mpfr_sqr(r->x, r->x, MPFR_RNDN);
    mpfr_div(r->y, r->y, r->x, MPFR_RNDN);
    mpfr_sub(r->x, r->i, r->t, MPFR_RNDN);
    mpfr_cos(r->x, r->x, MPFR_RNDN);
    mpfr_sqr(r->x, r->x, MPFR_RNDN);
    mpfr_div(r->x, r->y, r->x, MPFR_RNDN);
    mpfr_add(r->x, r->x, r->y, MPFR_RNDN);
    mpfr_div_ui(r->x, r->x, 2, MPFR_RNDN);
    mpfr_ui_sub(r->share, 1, r->x, MPFR_RNDN);
}

/* |d| (sin(t) along - cos(t) n) */
static void set_direction(refraction_truth *r)
{
    set(r->direction, (sure_vec3){0, 0, 0});
    mpfr_sin_cos(r->x, r->y, r->t, MPFR_RNDN);
    r->refracted = mpfr_get_d(r->y, MPFR_RNDN);
    mpfr_mul(r->x, r->x, r->length, MPFR_RNDN);
    mpfr_mul(r->y, r->y, r->length, MPFR_RNDN);
    mpfr_neg(r->y, r->y, MPFR_RNDN);
    move(r->direction, r->x, r->along);
    move(r->direction, r->y, r->n);
}

/* The angle of d with the line of n, and what of d is along the surface. */
static void set_angle(refraction_truth *r)
{
    true_dot(r->x, r->n, r->d);
    mpfr_neg(r->x, r->x, MPFR_RNDN);
    set(r->along, (sure_vec3){0, 0, 0});
    mpfr_set_ui(r->y, 1, MPFR_RNDN);
    move(r->along, r->y, r->d);
    move(r->along, r->x, r->n);
    make_unit(r->along, r->i);
    mpfr_abs(r->x, r->x, MPFR_RNDN);
    mpfr_atan2(r->i, r->i, r->x, MPFR_RNDN);
}

/* SURE_HIT and all of it, or SURE_MISS and neither direction nor share. Entry: the ratio is not
 * 1. */
static sure_status find(refraction_truth *r, const refraction_question *q)
{
    set(r->d, q->d);
    set(r->n, q->n);
    set_length(r->length, r->d);
    make_unit(r->n, r->x);
    set_angle(r);
    mpfr_cos(r->t, r->i, MPFR_RNDN);
    r->cosine = mpfr_get_d(r->t, MPFR_RNDN);
    mpfr_sin(r->t, r->i, MPFR_RNDN);
    mpfr_mul_d(r->t, r->t, q->ratio, MPFR_RNDN);
    mpfr_sqr(r->left, r->t, MPFR_RNDN);
    mpfr_ui_sub(r->left, 1, r->left, MPFR_RNDN);
    if (mpfr_sgn(r->left) < 0)
        return SURE_MISS;
    mpfr_asin(r->t, r->t, MPFR_RNDN);
    set_direction(r);
    if (mpfr_zero_p(r->i))
        set_share_along_normal(r, q->ratio);
    else
        set_share_by_angles(r);
    return SURE_HIT;
}

/* |x| / |d|, rounded up */
static double share_of_length(refraction_truth *r)
{
    mpfr_div(r->x, r->x, r->length, MPFR_RNDN);
    return fabs(mpfr_get_d(r->x, MPFR_RNDA));
}

/* How far the direction t is off the true one, over |d|. */
static double direction_off(refraction_truth *r, sure_vec3 t)
{
    set(r->v, t);
    mpfr_set_si(r->x, -1, MPFR_RNDN);
    move(r->v, r->x, r->direction);
    set_length(r->x, r->v);
    return share_of_length(r);
}

/* The greatest of |N x t - ratio N x d| = |N x (t - ratio d)|, ||t| - |d|| and N.t, over |d|, for N
 * of length 1. */
static double snell_off(refraction_truth *r, const refraction_question *q, sure_vec3 t)
{
    set(r->v, t);
    true_dot(r->x, r->n, r->v);
    double beyond = mpfr_sgn(r->x) > 0 ? share_of_length(r) : 0;
    set_length(r->x, r->v);
    mpfr_sub(r->x, r->x, r->length, MPFR_RNDN);
    double longer = share_of_length(r);
    mpfr_set_d(r->x, -q->ratio, MPFR_RNDN);
    move(r->v, r->x, r->d);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        mpfr_fmms(r->w[i], r->n[j], r->v[k], r->n[k], r->v[j], MPFR_RNDN);
    }
    set_length(r->x, r->w);
    return fmax(share_of_length(r), fmax(longer, beyond));
}

static double share_off(refraction_truth *r, double share)
{
    mpfr_sub_d(r->x, r->share, share, MPFR_RNDN);
    return fabs(mpfr_get_d(r->x, MPFR_RNDA));
}

static sure_status (*const refract[])(sure_vec3, sure_vec3, double,
                                      sure_vec3 *) = OF_TIERS(sure_refract);
static double (*const fresnel[])(sure_vec3, sure_vec3, double) = OF_TIERS(sure_refract_fresnel);

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
                                 refraction_truth *truth, sure_vec3 t, double share)
{
    double bound = direction_bound(tier, truth, q->ratio);
    if (!(direction_off(truth, t) <= bound))
        return "SURE_REFRACT_ULPS of the direction";
    if (!(snell_off(truth, q, t) <= bound))
        return "Law 5: Snell's law";
    if (!(share_off(truth, share) <= share_bound(tier, truth, q->ratio)))
        return "SURE_FRESNEL_ULPS of the share";
    return NULL;
}

static const char *truth_broken(sure_tier tier, const refraction_question *q,
                                refraction_truth *truth, refraction_counts *count)
{
    sure_vec3 t = {5, 6, 7};
    sure_status expected = find(truth, q);
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
    init(&truth);
    const char *broken = truth_broken(tier, q, &truth, count);
    clear(&truth);
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

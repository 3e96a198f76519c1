/* The extreme cases' truth, checked with rational numbers straight from the contract's definition
 * and without a look at how a case was made: the answer is the smallest t in [t_min, t_max] at
 * which the point lies on the boundary. */
#include "../../src/cases/extremes/extremes.h"
#include "../../src/cases/extremes/extremes_table.h"

#include <check.h>
#include <fenv.h>
#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MEMBERS 300

/* Polynomials c[0] + c[1] t + c[2] t^2 of the ray's t. */

typedef struct {
    mpq_t c[3];
} poly;

typedef struct {
    mpq_t x[3];
} rational_vec;

static void set_vec(rational_vec *v, sure_vec3 from)
{
    double x[3] = {from.x, from.y, from.z};
    for (int i = 0; i < 3; i++) {
        mpq_init(v->x[i]);
        mpq_set_d(v->x[i], x[i]);
    }
}

static void set_difference(rational_vec *v, sure_vec3 a, sure_vec3 b)
{
    rational_vec less;
    set_vec(v, a);
    set_vec(&less, b);
    for (int i = 0; i < 3; i++) {
        mpq_sub(v->x[i], v->x[i], less.x[i]);
        mpq_clear(less.x[i]);
    }
}

static void clear_vec(rational_vec *v)
{
    for (int i = 0; i < 3; i++)
        mpq_clear(v->x[i]);
}

static void dot(mpq_t result, const rational_vec *a, const rational_vec *b)
{
    mpq_t product;
    mpq_init(product);
    mpq_set_ui(result, 0, 1);
    for (int i = 0; i < 3; i++) {
        mpq_mul(product, a->x[i], b->x[i]);
        mpq_add(result, result, product);
    }
    mpq_clear(product);
}

static void init_poly(poly *p)
{
    for (int i = 0; i < 3; i++)
        mpq_init(p->c[i]);
}

static void clear_poly(poly *p)
{
    for (int i = 0; i < 3; i++)
        mpq_clear(p->c[i]);
}

static void add_times(poly *sum, const mpq_t factor, const poly *p)
{
    mpq_t product;
    mpq_init(product);
    for (int i = 0; i < 3; i++) {
        mpq_mul(product, factor, p->c[i]);
        mpq_add(sum->c[i], sum->c[i], product);
    }
    mpq_clear(product);
}

/* Of a linear polynomial. */
static void square(poly *result, const poly *p)
{
    mpq_mul(result->c[0], p->c[0], p->c[0]);
    mpq_mul(result->c[1], p->c[0], p->c[1]);
    mpq_mul_2exp(result->c[1], result->c[1], 1);
    mpq_mul(result->c[2], p->c[1], p->c[1]);
}

/* An object along the ray's line: it is where every f <= 0, its inside is where every f < 0. Of a
 * flat object a pair f, -f leaves no inside: all of it is boundary. */

typedef struct {
    int count;
    poly f[3];
    bool capped;        /* f[1] = 0 is the base's plane, f[2] = 0 the one through top or apex */
    mpq_t discriminant; /* of f[0], the only one that may be quadratic */
} section;

/* (w + t d) . v */
static void set_linear(poly *p, const rational_vec *w, const rational_vec *d,
                       const rational_vec *v)
{
    dot(p->c[0], w, v);
    dot(p->c[1], d, v);
}

/* |w + t d|^2 */
static void set_distance_squared(poly *p, const rational_vec *w, const rational_vec *d)
{
    dot(p->c[0], w, w);
    dot(p->c[1], w, d);
    mpq_mul_2exp(p->c[1], p->c[1], 1);
    dot(p->c[2], d, d);
}

static void subtract_square(mpq_t from, double x)
{
    mpq_t term;
    mpq_init(term);
    mpq_set_d(term, x);
    mpq_mul(term, term, term);
    mpq_sub(from, from, term);
    mpq_clear(term);
}

/* g = 0 from f[at] on. */
static void add_plane(section *cut, int at, const rational_vec *w, const rational_vec *d,
                      sure_vec3 normal)
{
    rational_vec n;
    set_vec(&n, normal);
    set_linear(&cut->f[at], w, d, &n);
    for (int i = 0; i < 2; i++)
        mpq_neg(cut->f[at + 1].c[i], cut->f[at].c[i]);
    cut->count = at + 2;
    clear_vec(&n);
}

/* With k = (p - base) . axis: f[1] = -k, f[2] = k - axis . axis, and
 * cylinder: f[0] = |p - base|^2 axis.axis - k^2 - r^2 axis.axis
 * cone:     f[0] = (|p - base|^2 axis.axis - k^2) axis.axis - r^2 (axis.axis - k)^2 */
static void set_capped(section *cut, const rational_vec *w, const rational_vec *d, sure_vec3 base,
                       sure_vec3 tip, double radius, bool cone)
{
    rational_vec axis;
    poly from_base, along, along_squared, width;
    mpq_t length, r, minus_one;
    mpq_inits(length, r, minus_one, NULL);
    mpq_set_si(minus_one, -1, 1);
    mpq_set_d(r, radius);
    init_poly(&from_base);
    init_poly(&along);
    init_poly(&along_squared);
    init_poly(&width);
    set_difference(&axis, tip, base);
    dot(length, &axis, &axis);
    set_linear(&along, w, d, &axis);
    set_distance_squared(&from_base, w, d);
    square(&along_squared, &along);

    add_times(&cut->f[1], minus_one, &along);
    mpq_set(cut->f[2].c[1], along.c[1]);
    mpq_sub(cut->f[2].c[0], along.c[0], length);

    add_times(&cut->f[0], length, &from_base);
    add_times(&cut->f[0], minus_one, &along_squared);
    mpq_mul(r, r, r);
    mpq_neg(r, r);
    if (cone) {
        for (int i = 0; i < 3; i++)
            mpq_mul(cut->f[0].c[i], cut->f[0].c[i], length);
        square(&width, &cut->f[2]);
        add_times(&cut->f[0], r, &width);
    } else {
        mpq_mul(r, r, length);
        mpq_add(cut->f[0].c[0], cut->f[0].c[0], r);
    }
    cut->count = 3;
    cut->capped = true;
    clear_poly(&from_base);
    clear_poly(&along);
    clear_poly(&along_squared);
    clear_poly(&width);
    clear_vec(&axis);
    mpq_clears(length, r, minus_one, NULL);
}

static sure_vec3 place_of(const sure_object *object)
{
    switch (object->shape) {
    case SURE_SHAPE_PLANE:
        return object->as.plane.point;
    case SURE_SHAPE_DISC:
        return object->as.disc.centre;
    case SURE_SHAPE_SPHERE:
        return object->as.sphere.centre;
    case SURE_SHAPE_CYLINDER:
        return object->as.cylinder.base;
    case SURE_SHAPE_CONE:
        return object->as.cone.base;
    }
    abort();
}

static void set_discriminant(section *cut)
{
    const poly *f = &cut->f[0];
    mpq_t product;
    mpq_init(product);
    mpq_mul(cut->discriminant, f->c[1], f->c[1]);
    mpq_mul(product, f->c[0], f->c[2]);
    mpq_mul_2exp(product, product, 2);
    mpq_sub(cut->discriminant, cut->discriminant, product);
    mpq_clear(product);
}

static void init_section(section *cut, const sure_case *question)
{
    const sure_object *object = &question->object;
    rational_vec w, d;
    cut->capped = false;
    mpq_init(cut->discriminant);
    for (int i = 0; i < 3; i++)
        init_poly(&cut->f[i]);
    set_difference(&w, question->ray.origin, place_of(object));
    set_vec(&d, question->ray.direction);
    switch (object->shape) {
    case SURE_SHAPE_PLANE:
        add_plane(cut, 0, &w, &d, object->as.plane.normal);
        break;
    case SURE_SHAPE_DISC:
        set_distance_squared(&cut->f[0], &w, &d);
        subtract_square(cut->f[0].c[0], object->as.disc.radius);
        add_plane(cut, 1, &w, &d, object->as.disc.normal);
        break;
    case SURE_SHAPE_SPHERE:
        set_distance_squared(&cut->f[0], &w, &d);
        subtract_square(cut->f[0].c[0], object->as.sphere.radius);
        cut->count = 1;
        break;
    case SURE_SHAPE_CYLINDER:
        set_capped(cut, &w, &d, object->as.cylinder.base, object->as.cylinder.top,
                   object->as.cylinder.radius, false);
        break;
    case SURE_SHAPE_CONE:
        set_capped(cut, &w, &d, object->as.cone.base, object->as.cone.apex,
                   object->as.cone.radius, true);
        break;
    }
    set_discriminant(cut);
    clear_vec(&w);
    clear_vec(&d);
}

static void clear_section(section *cut)
{
    for (int i = 0; i < 3; i++)
        clear_poly(&cut->f[i]);
    mpq_clear(cut->discriminant);
}

/* Numbers a + b sqrt(discriminant): all that is compared here is one of them. */

typedef struct {
    mpq_t a, b;
} surd;

static int surd_sign(const surd *x, const mpq_t discriminant)
{
    int a = mpq_sgn(x->a), b = mpq_sgn(x->b) * mpq_sgn(discriminant);
    if (a * b >= 0)
        return a != 0 ? a : b;
    mpq_t left, right;
    mpq_inits(left, right, NULL);
    mpq_mul(left, x->a, x->a);
    mpq_mul(right, x->b, x->b);
    mpq_mul(right, right, discriminant);
    int larger = mpq_cmp(left, right);
    mpq_clears(left, right, NULL);
    return larger > 0 ? a : larger < 0 ? b : 0;
}

static int surd_compare(const surd *x, const surd *y, const mpq_t discriminant)
{
    surd difference;
    mpq_inits(difference.a, difference.b, NULL);
    mpq_sub(difference.a, x->a, y->a);
    mpq_sub(difference.b, x->b, y->b);
    int sign = surd_sign(&difference, discriminant);
    mpq_clears(difference.a, difference.b, NULL);
    return sign;
}

static int surd_compare_double(const surd *x, double y, const mpq_t discriminant)
{
    surd other;
    mpq_inits(other.a, other.b, NULL);
    mpq_set_d(other.a, y);
    int sign = surd_compare(x, &other, discriminant);
    mpq_clears(other.a, other.b, NULL);
    return sign;
}

static int poly_sign(const poly *p, const surd *x, const mpq_t discriminant)
{
    surd slope, value;
    mpq_t term;
    mpq_inits(slope.a, slope.b, value.a, value.b, term, NULL);
    /* slope = c2 x + c1 */
    mpq_mul(slope.a, p->c[2], x->a);
    mpq_add(slope.a, slope.a, p->c[1]);
    mpq_mul(slope.b, p->c[2], x->b);
    /* value = slope x + c0 */
    mpq_mul(value.a, slope.b, x->b);
    mpq_mul(value.a, value.a, discriminant);
    mpq_mul(term, slope.a, x->a);
    mpq_add(value.a, value.a, term);
    mpq_add(value.a, value.a, p->c[0]);
    mpq_mul(value.b, slope.a, x->b);
    mpq_mul(term, slope.b, x->a);
    mpq_add(value.b, value.b, term);
    int sign = surd_sign(&value, discriminant);
    mpq_clears(slope.a, slope.b, value.a, value.b, term, NULL);
    return sign;
}

/* The definition. The points of the boundary on the line are a closed set that begins and ends at
 * roots, so the first in [t_min, t_max] is a root or t_min. */

#define CANDIDATES 5

typedef struct {
    int count;
    surd t[CANDIDATES];
} candidates;

static surd *add_candidate(candidates *list)
{
    surd *t = &list->t[list->count++];
    mpq_inits(t->a, t->b, NULL);
    return t;
}

static void add_roots(candidates *list, const poly *f, const mpq_t discriminant)
{
    if (mpq_sgn(f->c[2]) != 0) {
        mpq_t halved;
        mpq_init(halved);
        mpq_mul_2exp(halved, f->c[2], 1);
        for (int side = -1; side <= 1 && mpq_sgn(discriminant) >= 0; side += 2) {
            surd *root = add_candidate(list);
            mpq_div(root->a, f->c[1], halved);
            mpq_neg(root->a, root->a);
            mpq_set_si(root->b, side, 1);
            mpq_div(root->b, root->b, halved);
        }
        mpq_clear(halved);
    } else if (mpq_sgn(f->c[1]) != 0) {
        surd *root = add_candidate(list);
        mpq_div(root->a, f->c[0], f->c[1]);
        mpq_neg(root->a, root->a);
    }
}

static bool on_boundary(const section *cut, const surd *t)
{
    bool touches = false;
    for (int i = 0; i < cut->count; i++) {
        int sign = poly_sign(&cut->f[i], t, cut->discriminant);
        if (sign > 0)
            return false;
        touches = touches || sign == 0;
    }
    return touches;
}

static sure_part part_at(const section *cut, const sure_case *question, const surd *t)
{
    if (!cut->capped)
        return SURE_PART_SURFACE;
    if (poly_sign(&cut->f[1], t, cut->discriminant) == 0)
        return SURE_PART_BASE;
    if (question->object.shape == SURE_SHAPE_CYLINDER &&
        poly_sign(&cut->f[2], t, cut->discriminant) == 0)
        return SURE_PART_TOP;
    return SURE_PART_WALL;
}

typedef struct {
    sure_status status;
    sure_part part;
    bool at_t; /* t* is exactly the double that was asked about */
} verdict;

static verdict judge(const sure_case *question, double t)
{
    const sure_ray *ray = &question->ray;
    section cut;
    candidates list = {0};
    const surd *first = NULL;
    verdict result = {.status = SURE_MISS};
    init_section(&cut, question);
    mpq_set_d(add_candidate(&list)->a, ray->t_min);
    for (int i = 0; i < cut.count; i++)
        add_roots(&list, &cut.f[i], cut.discriminant);
    if (mpq_sgn(cut.discriminant) < 0) /* no root of f[0]: no square root in any number */
        mpq_set_ui(cut.discriminant, 0, 1);
    for (int i = 0; i < list.count; i++) {
        const surd *at = &list.t[i];
        if (surd_compare_double(at, ray->t_min, cut.discriminant) >= 0 &&
            (isinf(ray->t_max) ||
             surd_compare_double(at, ray->t_max, cut.discriminant) <= 0) &&
            on_boundary(&cut, at) &&
            (first == NULL || surd_compare(at, first, cut.discriminant) < 0))
            first = at;
    }
    if (first != NULL) {
        result.status = SURE_HIT;
        result.part = part_at(&cut, question, first);
        result.at_t = surd_compare_double(first, t, cut.discriminant) == 0;
    }
    for (int i = 0; i < list.count; i++)
        mpq_clears(list.t[i].a, list.t[i].b, NULL);
    clear_section(&cut);
    return result;
}

/* Which member a failure is about, and its question as a line of the case format. */
static const char *describe(const extreme *wrong, sure_shape shape, int family, uint64_t index)
{
    static char text[CASE_LINE_MAX + 100];
    char line[CASE_LINE_MAX];
    case_print(&wrong->question, line);
    snprintf(text, sizeof text, "%s, member %llu: %s", extreme_family_name(shape, family),
             (unsigned long long)index, line);
    return text;
}

/* Tests. */

/* The judge itself, on cases small enough for the eye. */
START_TEST(the_judge_follows_the_definition)
{
    static const struct {
        const char *line, *answer;
        double t;
    } known[] = {
        {"sphere -5 1 0 1 0 0 0 inf 0 0 0 1", "hit surface", 5},
        {"sphere -5 0x1.0000000000001p+0 0 1 0 0 0 inf 0 0 0 1", "miss", 0},
        {"sphere 0 0 0 0 2 0 0 inf 0 0 0 1", "hit surface", 0.5},
        {"sphere -5 0 0 1 0 0 4.5 5.5 0 0 0 1", "miss", 0},
        {"plane 0 0 3 1 0 0 0 inf 0 0 3 0 0 1", "hit surface", 0},
        {"plane 0 0 3 1 0 0 0 inf 0 0 2 0 0 1", "miss", 0},
        {"plane 0 0 3 1 0 -1 4 inf 0 0 0 0 0 1", "miss", 0},
        {"disc -5 0 0 1 0 0 0 inf 0 0 0 0 0 1 2", "hit surface", 3},
        {"disc 2 0 5 0 0 -1 0 inf 0 0 0 0 0 7 2", "hit surface", 5},
        {"disc 3 0 5 0 0 -1 0 inf 0 0 0 0 0 7 2", "miss", 0},
        {"cylinder -5 0 0 1 0 0 0 inf 0 0 0 0 0 4 2", "hit base", 3},
        {"cylinder -5 0 4 1 0 0 0 inf 0 0 0 0 0 4 2", "hit top", 3},
        {"cylinder -5 0 1 1 0 0 0 inf 0 0 0 0 0 4 2", "hit wall", 3},
        {"cylinder 2 0 9 0 0 -1 0 inf 0 0 0 0 0 4 2", "hit top", 5},
        {"cylinder 2 0 3 0 0 -1 0 inf 0 0 0 0 0 4 2", "hit wall", 0},
        {"cylinder 0 0 3 0 0 -1 0 inf 0 0 0 0 0 4 2", "hit base", 3},
        {"cylinder -5 0 5 1 0 0 0 inf 0 0 0 0 0 4 2", "miss", 0},
        {"cone -5 0 4 1 0 0 0 inf 0 0 0 0 0 4 2", "hit wall", 5},
        {"cone -5 0 2 1 0 0 0 inf 0 0 0 0 0 4 2", "hit wall", 4},
        {"cone -5 0 6 1 0 0 0 inf 0 0 0 0 0 4 2", "miss", 0},
        {"cone 0 -1 6 0 1 -2 0 inf 0 0 0 0 0 4 2", "hit wall", 1},
        {"cone 0 3 -2 0 -1 2 0 inf 0 0 0 0 0 4 2", "hit base", 1},
        {"cone 0 0 9 0 0 -1 0 inf 0 0 0 0 0 4 0", "hit wall", 5},
        {"cone 0 0 -9 0 0 1 0 inf 0 0 0 0 0 4 0", "hit base", 9},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        sure_case question;
        ck_assert_msg(case_read(known[i].line, &question), "%s", known[i].line);
        verdict found = judge(&question, known[i].t);
        char answer[32];
        if (found.status == SURE_HIT)
            snprintf(answer, sizeof answer, "hit %s", sure_part_name(found.part));
        else
            snprintf(answer, sizeof answer, "%s", sure_status_name(found.status));
        ck_assert_msg(strcmp(answer, known[i].answer) == 0, "%s: %s", known[i].line, answer);
        ck_assert_msg(found.status == SURE_MISS || found.at_t, "%s: t", known[i].line);
    }
}
END_TEST

START_TEST(every_truth_is_true)
{
    sure_shape shape = (sure_shape)_i;
    for (int family = 0; family < extreme_families(shape); family++)
        for (uint64_t index = 0; index < MEMBERS; index++) {
            extreme it = extreme_case(shape, family, index);
            const char *where = describe(&it, shape, family, index);
            ck_assert_msg(sure_object_check(&it.question.ray, &it.question.object) ==
                              SURE_FIELD_NONE, "invalid: %s", where);
            verdict truth = judge(&it.question, it.t);
            ck_assert_msg(it.status == truth.status, "%s instead of %s: %s",
                          sure_status_name(it.status), sure_status_name(truth.status), where);
            if (truth.status != SURE_HIT)
                continue;
            ck_assert_msg(it.part == truth.part, "%s instead of %s: %s",
                          sure_part_name(it.part), sure_part_name(truth.part), where);
            ck_assert_msg(!it.t_known || truth.at_t, "t is not %a: %s", it.t, where);
        }
}
END_TEST

static double *radius_of(sure_object *object)
{
    switch (object->shape) {
    case SURE_SHAPE_PLANE:
        break;
    case SURE_SHAPE_DISC:
        return &object->as.disc.radius;
    case SURE_SHAPE_SPHERE:
        return &object->as.sphere.radius;
    case SURE_SHAPE_CYLINDER:
        return &object->as.cylinder.radius;
    case SURE_SHAPE_CONE:
        return &object->as.cone.radius;
    }
    return NULL;
}

static bool is_one_of(const char *name, const char *const names[], int count)
{
    for (int i = 0; i < count; i++)
        if (strcmp(name, names[i]) == 0)
            return true;
    return false;
}

/* What a touching case answers hangs on the last bit of the radius. */
START_TEST(one_ulp_of_the_radius_decides)
{
    static const char *const touching[] = {"tangent", "rim", "along the wall"};
    static const char *const missed[] = {"neighbour outside", "rim missed"};
    sure_shape shape = (sure_shape)_i;
    int decided = 0;
    for (int family = 0; family < extreme_families(shape); family++) {
        const char *name = extreme_family_name(shape, family);
        bool touches = is_one_of(name, touching, 3);
        if (!touches && !is_one_of(name, missed, 2))
            continue;
        decided++;
        for (uint64_t index = 0; index < MEMBERS; index++) {
            extreme it = extreme_case(shape, family, index);
            double *radius = radius_of(&it.question.object);
            *radius = nextafter(*radius, touches ? 0 : INFINITY);
            verdict other = judge(&it.question, it.t);
            ck_assert_msg(other.status != it.status, "%s", describe(&it, shape, family, index));
        }
    }
    ck_assert_int_ge(decided, 2);
}
END_TEST

static bool same(const extreme *a, const extreme *b)
{
    char line[2][CASE_LINE_MAX];
    case_print(&a->question, line[0]);
    case_print(&b->question, line[1]);
    return strcmp(line[0], line[1]) == 0 && a->status == b->status && a->part == b->part &&
           a->t == b->t && a->t_known == b->t_known;
}

/* A step that rounds would raise the flag, or answer to the mode. */
START_TEST(making_rounds_nothing)
{
    static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    sure_shape shape = (sure_shape)_i;
    for (int family = 0; family < extreme_families(shape); family++)
        for (uint64_t index = 0; index < MEMBERS; index++) {
            feclearexcept(FE_ALL_EXCEPT);
            extreme it = extreme_case(shape, family, index);
            int raised = fetestexcept(FE_INEXACT | FE_OVERFLOW | FE_UNDERFLOW);
            ck_assert_msg(raised == 0, "%s", describe(&it, shape, family, index));
            for (int i = 0; i < 3; i++) {
                fesetround(modes[i]);
                extreme again = extreme_case(shape, family, index);
                fesetround(FE_TONEAREST);
                ck_assert_msg(same(&it, &again), "%s", describe(&it, shape, family, index));
            }
        }
}
END_TEST

START_TEST(members_are_pure_and_differ)
{
    sure_shape shape = (sure_shape)_i;
    uint64_t last = UINT64_MAX;
    for (int family = 0; family < extreme_families(shape); family++) {
        extreme at_end = extreme_case(shape, family, last);
        extreme before = extreme_case(shape, family, MEMBERS);
        for (uint64_t index = MEMBERS; index-- > 0;) {
            extreme it = extreme_case(shape, family, index);
            ck_assert_msg(!same(&it, &before) && !same(&it, &at_end), "%s",
                          describe(&it, shape, family, index));
            before = it;
        }
        extreme again = extreme_case(shape, family, last);
        ck_assert(same(&at_end, &again));
    }
}
END_TEST

/* FNV-1a over the text of the first members: another compiler or machine that made others would be
 * found out. A change of the families changes it. */
START_TEST(members_are_the_same_everywhere)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (int shape = 0; shape < SURE_SHAPES; shape++)
        for (int family = 0; family < extreme_families((sure_shape)shape); family++)
            for (uint64_t index = 0; index < 10; index++) {
                extreme it = extreme_case((sure_shape)shape, family, index);
                char line[CASE_LINE_MAX];
                case_print(&it.question, line);
                for (const char *c = line; *c; c++)
                    hash = (hash ^ (unsigned char)*c) * UINT64_C(0x100000001b3);
            }
    ck_assert_uint_eq(hash, UINT64_C(17407937397585315874));
}
END_TEST

START_TEST(families_are_named_and_reasoned)
{
    sure_shape shape = (sure_shape)_i;
    int families = extreme_families(shape);
    ck_assert_int_ge(families, 8);
    for (int family = 0; family < families; family++) {
        const char *name = extreme_family_name(shape, family);
        const char *reason = extreme_family_reason(shape, family);
        ck_assert_msg(strlen(name) > 0 && strlen(name) <= 18, "%s", name);
        ck_assert_msg(strlen(reason) > 20 && strlen(reason) <= 90, "%s: %s", name, reason);
        ck_assert_msg(strchr(reason, '\n') == NULL, "%s", name);
        for (int other = 0; other < family; other++)
            ck_assert_str_ne(name, extreme_family_name(shape, other));
    }
}
END_TEST

static double largest(sure_vec3 v)
{
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

START_TEST(lengths_are_as_named)
{
    sure_shape shape = (sure_shape)_i;
    int seen = 0;
    for (int family = 0; family < extreme_families(shape); family++) {
        const char *name = extreme_family_name(shape, family);
        bool far = strcmp(name, "far") == 0, huge = strcmp(name, "huge") == 0;
        bool tiny = strcmp(name, "tiny") == 0;
        seen += far + huge + tiny;
        for (uint64_t index = 0; index < MEMBERS; index++) {
            extreme it = extreme_case(shape, family, index);
            double from = largest(it.question.ray.origin);
            double unit = ldexp(1, tiny ? -700 : huge ? 640 : 0);
            if (huge)
                ck_assert(from > unit && from < ldexp(1, 1023));
            if (tiny)
                ck_assert(from < ldexp(1, -700 + 52) && from >= ldexp(1, -1022));
            if (far && shape != SURE_SHAPE_PLANE)
                ck_assert(from > 100 * *radius_of(&it.question.object));
        }
    }
    ck_assert_int_eq(seen, 3);
}
END_TEST

/* The table. */

/* More than are asked at once. */
#define TABLE_COUNT 1100

static uint64_t count_wrong(sure_shape shape, int family, sure_tier tier)
{
    uint64_t wrong = 0;
    for (uint64_t index = 0; index < TABLE_COUNT; index++) {
        extreme it = extreme_case(shape, family, index);
        sure_hit hit = {0, 0, SURE_PART_SURFACE};
        sure_status status =
            sure_object_hit(&it.question.ray, &it.question.object, tier, &hit);
        if (status != it.status || (status == SURE_HIT && hit.part != it.part))
            wrong++;
    }
    return wrong;
}

static void check_share(const char *printed, uint64_t wrong, uint64_t cases, const char *row)
{
    char expected[16];
    if (wrong > 0 && 1000 * wrong < cases)
        strcpy(expected, "<0.1");
    else if (wrong < cases && 1000 * (cases - wrong) < cases)
        strcpy(expected, ">99.9");
    else
        snprintf(expected, sizeof expected, wrong == 0 || wrong == cases ? "%.0f" : "%.1f",
                 100 * (double)wrong / (double)cases);
    ck_assert_msg(strcmp(printed, expected) == 0, "%s, not %s: %s", printed, expected, row);
}

/* A row's label and, for each tier, three words. */
static void check_row(const char *row, const char *label, const uint64_t wrong[], uint64_t cases)
{
    char copy[200];
    ck_assert_uint_lt(strlen(row), sizeof copy);
    strcpy(copy, row);
    char *text = copy + strspn(copy, " ");
    ck_assert_msg(strncmp(text, label, strlen(label)) == 0, "%s: %s", label, row);
    char *word = strtok(text + strlen(label), " ");
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        ck_assert_ptr_nonnull(word);
        check_share(word, wrong[tier], cases, row);
        for (int i = 0; i < 3; i++)
            word = strtok(NULL, " ");
    }
    ck_assert_ptr_null(word);
}

static const char *next_line(FILE *in)
{
    static char line[400];
    ck_assert_ptr_nonnull(fgets(line, sizeof line, in));
    line[strcspn(line, "\n")] = '\0';
    ck_assert_msg(strlen(line) <= 100, "%s", line);
    return line;
}

START_TEST(the_table_counts_wrong_answers)
{
    FILE *printed = tmpfile();
    uint64_t overall[SURE_TIERS] = {0}, cases = 0;
    ck_assert_int_eq(extremes_table(printed, TABLE_COUNT), 0);
    rewind(printed);
    while (strcmp(next_line(printed), "plane") != 0)
        ;
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        uint64_t of_shape[SURE_TIERS] = {0};
        int families = extreme_families((sure_shape)shape);
        if (shape > 0)
            ck_assert_str_eq(next_line(printed), sure_shape_name((sure_shape)shape));
        for (int family = 0; family < families; family++) {
            uint64_t wrong[SURE_TIERS];
            for (int tier = 0; tier < SURE_TIERS; tier++) {
                wrong[tier] = count_wrong((sure_shape)shape, family, (sure_tier)tier);
                of_shape[tier] += wrong[tier];
                overall[tier] += wrong[tier];
            }
            check_row(next_line(printed), extreme_family_name((sure_shape)shape, family), wrong,
                      TABLE_COUNT);
        }
        check_row(next_line(printed), "all", of_shape, (uint64_t)families * TABLE_COUNT);
        cases += (uint64_t)families * TABLE_COUNT;
    }
    check_row(next_line(printed), "all shapes", overall, cases);
    ck_assert_uint_gt(overall[SURE_TIER_TEXTBOOK], overall[SURE_TIER_STABLE]);
    ck_assert_uint_eq(overall[SURE_TIER_CERTAIN], 0);
    ck_assert_uint_eq(overall[SURE_TIER_EXACT], 0);
    ck_assert_int_eq(fgetc(printed), EOF);
    fclose(printed);
}
END_TEST

/* Where t* is a known double, exact finds it and certain is within its error of it. */
START_TEST(sure_tiers_find_t)
{
    sure_shape shape = (sure_shape)_i;
    int known = 0;
    for (int family = 0; family < extreme_families(shape); family++)
        for (uint64_t index = 0; index < MEMBERS; index++) {
            extreme it = extreme_case(shape, family, index);
            const char *where = describe(&it, shape, family, index);
            const sure_case *question = &it.question;
            if (it.status != SURE_HIT || !it.t_known)
                continue;
            sure_hit certain = {0}, exact = {0};
            sure_object_hit(&question->ray, &question->object, SURE_TIER_CERTAIN, &certain);
            sure_object_hit(&question->ray, &question->object, SURE_TIER_EXACT, &exact);
            ck_assert_msg(exact.t == it.t, "%a, not %a: %s", exact.t, it.t, where);
            ck_assert_msg(fabs(certain.t - it.t) <= certain.t_error, "%a: %s", certain.t, where);
            known++;
        }
    ck_assert_int_gt(known, MEMBERS);
}
END_TEST

START_TEST(the_table_reports_a_full_disc)
{
    FILE *full = fopen("/dev/full", "w");
    ck_assert_ptr_nonnull(full);
    ck_assert_int_ne(extremes_table(full, 1), 0);
    fclose(full);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("extremes");
    TCase *cases = tcase_create("extremes");
    tcase_set_timeout(cases, 120);
    tcase_add_test(cases, the_judge_follows_the_definition);
    tcase_add_loop_test(cases, every_truth_is_true, 0, SURE_SHAPES);
    tcase_add_loop_test(cases, one_ulp_of_the_radius_decides, 1, SURE_SHAPES);
    tcase_add_loop_test(cases, making_rounds_nothing, 0, SURE_SHAPES);
    tcase_add_loop_test(cases, members_are_pure_and_differ, 0, SURE_SHAPES);
    tcase_add_test(cases, members_are_the_same_everywhere);
    tcase_add_loop_test(cases, families_are_named_and_reasoned, 0, SURE_SHAPES);
    tcase_add_loop_test(cases, lengths_are_as_named, 0, SURE_SHAPES);
    tcase_add_test(cases, the_table_counts_wrong_answers);
    tcase_add_loop_test(cases, sure_tiers_find_t, 0, SURE_SHAPES);
    tcase_add_test(cases, the_table_reports_a_full_disc);
    suite_add_tcase(suite, cases);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}

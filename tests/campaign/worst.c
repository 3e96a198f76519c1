/* SPDX-License-Identifier: MIT */
#include "worst.h"

#include "../../src/shapes/capped/capped_stages.h"
#include "../../src/stages/close.h"
#include "../../src/stages/rows.h"

#include "json_file.h"

const char *const worst_names[WORST_QUESTIONS] = {"decision", "cap", "rounding"};

static exact_arena room;

/* floor(log2 |x|) */
static int binade(exact x)
{
    int exponent;
    exact_top(x, &exponent);
    return exponent + 63;
}

/* By how many binades a sum is below the largest of its terms; 0: it is 0. */
static int binades_below(exact sum, const exact *terms, int count)
{
    int most = INT_MIN;
    for (int i = 0; i < count; i++) {
        if (terms[i].sign != 0 && binade(terms[i]) > most)
            most = binade(terms[i]);
    }
    return sum.sign == 0 || most < binade(sum) ? 0 : most - binade(sum);
}

static int of_two(exact_context *c, two_terms_exact terms)
{
    const exact both[2] = {terms.more, terms.less};
    return binades_below(difference_exact(c, terms), both, 2);
}

static int of_product(exact_context *c, vector_exact u, vector_exact v)
{
    const exact all[3] = {exact_mul(c, u.x, v.x), exact_mul(c, u.y, v.y), exact_mul(c, u.z, v.z)};
    return binades_below(vector_dot_exact(c, u, v), all, 3);
}

static int greater(int x, int y)
{
    return x > y ? x : y;
}

static int body_bits(exact_context *c, const sure_ray *ray, const sure_object *object)
{
    const shape_row *row = row_of(object);
    line_coefficients l;
    two_terms_dd terms = close_of(row)->discriminant(ray, &object->as);
    double larger = fmax(fabs(terms.more.head), fabs(terms.less.head));
    row->exact_interval(c, ray, &object->as, &l);
    if (l.quarter.sign == 0 || !isnormal(larger))
        return 0;
    return greater(ilogb(larger) - binade(l.quarter), 0);
}

static int plane_bits(exact_context *c, const sure_ray *ray, const sure_object *object)
{
    const sure_plane *s = &object->as.plane;
    vector_exact n = vector_of_exact(c, s->normal);
    return greater(of_product(c, n, vector_between_exact(c, s->point, ray->origin)),
                   of_product(c, n, vector_of_exact(c, ray->direction)));
}

static int rim_bits(exact_context *c, vector_exact normal, vector_exact m, vector_exact d, exact r)
{
    exact e = vector_dot_exact(c, normal, d), h = vector_dot_exact(c, normal, m);
    return of_two(c, disc_rim_exact(c, e, h, m, d, r));
}

static int disc_bits(exact_context *c, const sure_ray *ray, const sure_object *object)
{
    const sure_disc *s = &object->as.disc;
    return rim_bits(c, vector_of_exact(c, s->normal),
                    vector_between_exact(c, s->centre, ray->origin),
                    vector_of_exact(c, ray->direction), exact_of(c, s->radius));
}

static int cap_bits(exact_context *c, const sure_ray *ray, sure_vec3 from, sure_vec3 to, double r)
{
    capped_point w = capped_point_of(c, ray, from, to, r);
    return rim_bits(c, w.axis, w.m, w.d, w.radius);
}

static int cylinder_caps(exact_context *c, const sure_ray *ray, const sure_object *object)
{
    const sure_cylinder *s = &object->as.cylinder;
    return greater(cap_bits(c, ray, s->base, s->top, s->radius),
                   cap_bits(c, ray, s->top, s->base, s->radius));
}

static int cone_cap(exact_context *c, const sure_ray *ray, const sure_object *object)
{
    const sure_cone *s = &object->as.cone;
    return cap_bits(c, ray, s->base, s->apex, s->radius);
}

static int box_bits(exact_context *c, const sure_ray *ray, const sure_object *object)
{
    line_coefficients l = {.speed = exact_of(c, 0)};
    row_of(object)->exact_interval(c, ray, &object->as, &l);
    return l.speed.sign == 0 ? 0 : of_two(c, (two_terms_exact){l.top, l.base});
}

/* Sign of t* - (x + 2^exponent), or of t* - (x - 2^exponent). */
static int beside(exact_context *c, const line_coefficients *l, end_kind at, exact x, int sign,
                  int exponent)
{
    size_t mark = exact_mark(c);
    exact bound = exact_add(c, x, exact_scaled(c, sign, exponent));
    int side = line_compare(c, l, at, bound, exact_of(c, 1));
    exact_release(c, mark);
    return side;
}

/* The midpoint beside the rounded t lies on the side where t* is, `side`: t* is between. */
static int bits_beyond(exact_context *c, const line_coefficients *l, end_kind at, double t,
                       int side)
{
    double next = nextafter(t, side > 0 ? INFINITY : -INFINITY);
    int ulp = ilogb(fabs(next - t)), bits = 53;
    if (isinf(next))
        return 0; /* nothing lies beyond */
    exact both = exact_add(c, exact_of(c, t), exact_of(c, next));
    exact middle = exact_mul(c, both, exact_scaled(c, 1, -1));
    if (line_compare(c, l, at, middle, exact_of(c, 1)) != -side)
        return 0; /* a tie, which is told exactly; or t is not the nearest, which the check tells */
    while (beside(c, l, at, middle, -side, ulp - (bits - 53) - 1) == side)
        bits++;
    return bits;
}

static int rounding_bits(exact_context *c, const shape_row *row, const sure_ray *ray,
                         const void *shape, double t)
{
    line_coefficients l;
    tagged_end first;
    bool leaves;
    if (!isnormal(t) || line_hit(c, ray, row, shape, &l, &first, &leaves) != SURE_HIT ||
        first.at == END_START || first.at == END_ENDLESS)
        return 0;
    int side = line_compare(c, &l, first.at, exact_of(c, t), exact_of(c, 1));
    return side == 0 ? 0 : bits_beyond(c, &l, first.at, t, side);
}

static int rounding_of(exact_context *c, const sure_ray *ray, const sure_object *object)
{
    sure_hit hit;
    if (sure_object_hit(ray, object, SURE_TIER_EXACT, &hit) != SURE_HIT)
        return 0;
    return rounding_bits(c, row_of(object), ray, &object->as, hit.t);
}

/* And the degree of what is asked, as a polynomial of inputs and midpoint. */
static const struct {
    int (*bits)(exact_context *, const sure_ray *, const sure_object *);
    int degree;
} questions[SURE_SHAPES][WORST_QUESTIONS] = {
    [SURE_SHAPE_PLANE] = {{plane_bits, 2}, {NULL, 0}, {rounding_of, 3}},
    [SURE_SHAPE_DISC] = {{disc_bits, 6}, {NULL, 0}, {rounding_of, 3}},
    [SURE_SHAPE_SPHERE] = {{body_bits, 4}, {NULL, 0}, {rounding_of, 4}},
    [SURE_SHAPE_CYLINDER] = {{body_bits, 6}, {cylinder_caps, 6}, {rounding_of, 6}},
    [SURE_SHAPE_CONE] = {{body_bits, 8}, {cone_cap, 6}, {rounding_of, 8}},
    [SURE_SHAPE_BOX] = {{box_bits, 2}, {NULL, 0}, {rounding_of, 2}},
};

int worst_bound(sure_shape shape, worst_question of)
{
    int degree = questions[shape][of].degree;
    return degree == 0 ? 0 : 2099 * degree + 12;
}

int worst_bits(const sure_case *question, worst_question of)
{
    const sure_object *object = &question->object;
    exact_context c = exact_start(&room);
    return questions[object->shape][of].bits
               ? questions[object->shape][of].bits(&c, &question->ray, object)
               : 0;
}

/* Is it the closer call? */
static bool is_before(const worst_call *a, const worst_call *b)
{
    if (a->bits != b->bits)
        return a->bits > b->bits;
    return a->which != b->which ? a->which < b->which : a->index < b->index;
}

void worst_add(worst_calls *to, worst_call more)
{
    int at = to->count;
    if (more.bits == 0)
        return;
    while (at > 0 && is_before(&more, &to->list[at - 1]))
        at--;
    if (at == WORST_KEPT)
        return;
    to->count += to->count < WORST_KEPT;
    for (int i = to->count - 1; i > at; i--)
        to->list[i] = to->list[i - 1];
    to->list[at] = more;
}

void worst_look(const sure_case *question, regime which, uint64_t index,
                worst_calls to[WORST_QUESTIONS])
{
    if (sure_object_check(&question->ray, &question->object) != SURE_FIELD_NONE)
        return;
    for (int i = 0; i < WORST_QUESTIONS; i++)
        worst_add(&to[i], (worst_call){worst_bits(question, (worst_question)i), which, index});
}

json_t *worst_calls_json(const worst_calls *of)
{
    json_t *list = json_array();
    for (int i = 0; i < of->count; i++)
        json_array_append_new(list, json_pack("[i, s, I]", of->list[i].bits,
                                              regime_name(of->list[i].which),
                                              (json_int_t)of->list[i].index));
    return list;
}

const char *worst_calls_take(const json_t *list, worst_calls *read)
{
    const json_t *item;
    size_t i;
    *read = (worst_calls){0};
    json_array_foreach(list, i, item)
    {
        worst_call *one = &read->list[i];
        const char *name = json_string_value(json_array_get(item, 1));
        if (i >= WORST_KEPT || json_array_size(item) != 3 || !name ||
            !regime_from_name(name, &one->which) ||
            !json_take_count(json_array_get(item, 2), &one->index))
            return "expected worst cases";
        one->bits = (int)json_integer_value(json_array_get(item, 0));
        if (one->bits < 1 || (i > 0 && !is_before(one - 1, one)))
            return "worst cases that are in another order";
        read->count++;
    }
    return read->count > 0 ? NULL : "no worst cases";
}

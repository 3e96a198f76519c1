/* SPDX-License-Identifier: MIT */
#include "worst.h"

#include "../../src/stages/rows.h"

#include "json_file.h"

const char *const worst_names[WORST_QUESTIONS] = {"decision", "rounding"};

static exact_arena room;

/* Of the discriminant or of the body at a midpoint, as a polynomial of inputs and midpoint. */
static const struct {
    int decision, rounding;
} degrees[SURE_SHAPES] = {
    [SURE_SHAPE_PLANE] = {0, 3},    [SURE_SHAPE_DISC] = {0, 3}, [SURE_SHAPE_SPHERE] = {4, 4},
    [SURE_SHAPE_CYLINDER] = {6, 6}, [SURE_SHAPE_CONE] = {8, 8}, [SURE_SHAPE_BOX] = {0, 2},
};

int worst_bound(sure_shape shape, worst_question of)
{
    int degree = of == WORST_DECISION ? degrees[shape].decision : degrees[shape].rounding;
    return degree == 0 ? 0 : 2099 * degree + 12;
}

/* floor(log2 |x|) */
static int binade(exact x)
{
    int exponent;
    exact_top(x, &exponent);
    return exponent + 63;
}

static int decision_bits(const shape_row *row, const sure_ray *ray, const void *shape)
{
    exact_context c = exact_start(&room);
    line_coefficients l;
    if (!row->discriminant_dd)
        return 0;
    two_terms_dd terms = row->discriminant_dd(ray, shape);
    double larger = fmax(fabs(terms.more.head), fabs(terms.less.head));
    row->exact_interval(&c, ray, shape, &l);
    if (l.quarter.sign == 0 || !isnormal(larger))
        return 0;
    int bits = ilogb(larger) - binade(l.quarter);
    return bits > 0 ? bits : 0;
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
    if (line_compare(c, l, at, middle, exact_of(c, 1)) == 0)
        return 0; /* a tie, which is told exactly */
    while (beside(c, l, at, middle, -side, ulp - (bits - 53) - 1) == side)
        bits++;
    return bits;
}

static int rounding_bits(const shape_row *row, const sure_ray *ray, const void *shape, double t)
{
    exact_context c = exact_start(&room);
    line_coefficients l;
    tagged_end first;
    bool leaves;
    if (!isnormal(t) || line_hit(&c, ray, row, shape, &l, &first, &leaves) != SURE_HIT ||
        first.at == END_START || first.at == END_ENDLESS)
        return 0;
    int side = line_compare(&c, &l, first.at, exact_of(&c, t), exact_of(&c, 1));
    return side == 0 ? 0 : bits_beyond(&c, &l, first.at, t, side);
}

int worst_bits(const sure_case *question, worst_question of)
{
    const sure_object *object = &question->object;
    const shape_row *row = row_of(object);
    sure_hit hit;
    if (of == WORST_DECISION)
        return decision_bits(row, &question->ray, &object->as);
    if (sure_object_hit(&question->ray, object, SURE_TIER_EXACT, &hit) != SURE_HIT)
        return 0;
    return rounding_bits(row, &question->ray, &object->as, hit.t);
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

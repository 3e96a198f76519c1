/* SPDX-License-Identifier: MIT */
/* The ray's line through an object: its polynomials, read off values, and the chord between two of
 * their changes of sign. */
#include "bisection_line.h"

void ray_point(const world *w, int tau, vector *out)
{
    for (int i = 0; i < 3; i++) {
        mpz_mul_si(out->x[i], w->direction.x[i], tau);
        mpz_add(out->x[i], out->x[i], w->origin.x[i]);
    }
}

/* From a polynomial in tau to a positive multiple of it in t. */
void substitute_t(const world *w, polynomial *p, unsigned degree)
{
    for (unsigned i = 0; i <= degree; i++) {
        mp_bitcnt_t power =
            w->shift > 0 ? (mp_bitcnt_t)w->shift * (degree - i) : (mp_bitcnt_t)-w->shift * i;
        mpz_mul_2exp(p->term[i], p->term[i], power);
    }
}

/* The quadratic that has the values of `body` at tau = -1, 0 and 1, doubled. */
void body_on_line(const world *w, polynomial *out)
{
    vector p;
    mpz_t before, here, after;
    vector_init(&p);
    mpz_inits(before, here, after, (mpz_ptr)NULL);
    ray_point(w, -1, &p);
    w->row->body(w, &p, before);
    ray_point(w, 0, &p);
    w->row->body(w, &p, here);
    ray_point(w, 1, &p);
    w->row->body(w, &p, after);

    mpz_mul_si(out->term[0], here, 2);
    mpz_sub(out->term[1], after, before);
    mpz_add(out->term[2], after, before);
    mpz_sub(out->term[2], out->term[2], out->term[0]);
    substitute_t(w, out, 2);
    mpz_clears(before, here, after, (mpz_ptr)NULL);
    vector_clear(&p);
}

/* How far P is on the inner side of each plane. */
void planes_on_line(const world *w, polynomial *inner)
{
    plane side;
    vector offset;
    vector_init(&side.outward);
    vector_init(&offset);
    mpz_init(side.reach);
    vector_subtract(&offset, &w->origin, &w->anchor);
    for (int i = 0; i < w->row->planes; i++) {
        w->row->plane(w, i, &side);
        dot(inner[i].term[0], &side.outward, &offset);
        mpz_sub(inner[i].term[0], side.reach, inner[i].term[0]);
        dot(inner[i].term[1], &side.outward, &w->direction);
        mpz_neg(inner[i].term[1], inner[i].term[1]);
        substitute_t(w, &inner[i], 1);
    }
    vector_clear(&side.outward);
    vector_clear(&offset);
    mpz_clear(side.reach);
}

void line_init(line *l, int planes)
{
    l->planes = planes;
    polynomial_init(&l->body);
    for (int i = 0; i < planes; i++)
        polynomial_init(&l->inner[i]);
    location_init(&l->chord.enter);
    location_init(&l->chord.leave);
    l->chord.empty = l->chord.endless = l->chord.solid = false;
}

void line_clear(line *l)
{
    polynomial_clear(&l->body);
    for (int i = 0; i < l->planes; i++)
        polynomial_clear(&l->inner[i]);
    location_clear(&l->chord.enter);
    location_clear(&l->chord.leave);
}

/* The root of a linear polynomial. */
static void crossing(fraction *t, const polynomial *p)
{
    fraction_set_quotient(t, p->term[0], p->term[1]);
    mpz_neg(t->num, t->num);
}

/* +-2^k, beyond every root of a quadratic: those are less than 1 + max |p0/p2|, |p1/p2|. */
static void far_points(fraction *low, fraction *high, const polynomial *p)
{
    long leading = (long)mpz_sizeinbase(p->term[2], 2);
    long power = 0;
    for (int i = 0; i < 2; i++) {
        long excess = (long)mpz_sizeinbase(p->term[i], 2) - leading + 1;
        power = excess > power ? excess : power;
    }
    fraction_set_integer(high, 1);
    mpz_mul_2exp(high->num, high->num, (mp_bitcnt_t)power + 1);
    fraction_set(low, high);
    mpz_neg(low->num, low->num);
}

/* What the planes leave of the line: from the last crossing inwards to the first outwards. `open`
 * is false where no point is strictly within all. */
typedef struct {
    bool empty, bounded, open, low_known, high_known;
    fraction low, high;
} stretch;

static void narrow(stretch *s, const polynomial *inner)
{
    int rising = mpz_sgn(inner->term[1]), start = mpz_sgn(inner->term[0]);
    if (rising == 0) {
        s->empty = s->empty || start < 0;
        s->open = s->open && start > 0;
        return;
    }
    fraction at;
    fraction_init(&at);
    crossing(&at, inner);
    fraction *end = rising > 0 ? &s->low : &s->high;
    bool *known = rising > 0 ? &s->low_known : &s->high_known;
    if (!*known || fraction_compare(&at, end) * rising > 0)
        fraction_set(end, &at);
    *known = true;
    fraction_clear(&at);
}

/* Planes come in pairs, so that a line that crosses one crosses one the other way. */
static void between_planes(const line *l, stretch *s)
{
    for (int i = 0; i < l->planes; i++)
        narrow(s, &l->inner[i]);
    s->bounded = s->low_known && s->high_known;
    if (!s->bounded)
        return;
    int order = fraction_compare(&s->low, &s->high);
    s->empty = s->empty || order > 0;
    s->open = s->open && order < 0;
}

/* The outer samples. A line that no plane bounds is endless where its body is constant (both
 * false); otherwise two points beyond the roots of its body, which is convex along it, do. */
static bool outer_samples(line *l, stretch *s)
{
    between_planes(l, s);
    l->chord.empty = s->empty;
    l->chord.endless = !s->empty && !s->bounded && mpz_sgn(l->body.term[2]) == 0;
    if (!s->bounded && !s->empty && !l->chord.endless)
        far_points(&s->low, &s->high, &l->body);
    return !(l->chord.empty || l->chord.endless);
}

/* -p1/(2 p2), where a quadratic turns, if that is between the outer samples; else `low`. */
static void middle_sample(const polynomial *p, const fraction *low, const fraction *high,
                          fraction *middle)
{
    fraction_set(middle, low);
    if (mpz_sgn(p->term[2]) == 0)
        return;
    mpz_t twice;
    mpz_init(twice);
    mpz_mul_si(twice, p->term[2], -2);
    fraction vertex;
    fraction_init(&vertex);
    fraction_set_quotient(&vertex, p->term[1], twice);
    if (fraction_compare(low, &vertex) < 0 && fraction_compare(&vertex, high) < 0)
        fraction_set(middle, &vertex);
    fraction_clear(&vertex);
    mpz_clear(twice);
}

/* From an outer sample inwards: the outer one itself if it is not outside the body; otherwise
 * the root before the first sample that is not. False if all are outside. */
static bool find_end(location *end, const polynomial *p, const fraction sample[3],
                     const int sign[3], int outer, int step)
{
    for (int i = outer; i >= 0 && i < 3; i += step) {
        if (sign[i] > 0)
            continue;
        if (i == outer)
            location_set_fraction(end, &sample[i]);
        else
            location_set_root(end, p, &sample[i - step], &sample[i]);
        return true;
    }
    return false;
}

/* Between consecutive samples the body's function is monotone, so its sign changes once at most. */
static void find_ends(line *l, const stretch *s)
{
    fraction sample[3];
    int sign[3];
    for (int i = 0; i < 3; i++)
        fraction_init(&sample[i]);
    fraction_set(&sample[0], &s->low);
    fraction_set(&sample[2], &s->high);
    middle_sample(&l->body, &sample[0], &sample[2], &sample[1]);
    for (int i = 0; i < 3; i++) {
        sign[i] = polynomial_sign(&l->body, &sample[i]);
        l->chord.solid = l->chord.solid || (sign[i] < 0 && s->open);
    }
    l->chord.empty = !find_end(&l->chord.enter, &l->body, sample, sign, 0, 1) ||
                     !find_end(&l->chord.leave, &l->body, sample, sign, 2, -1);
    for (int i = 0; i < 3; i++)
        fraction_clear(&sample[i]);
}

void find_chord(line *l)
{
    stretch s = {.open = true};
    fraction_init(&s.low);
    fraction_init(&s.high);
    if (outer_samples(l, &s))
        find_ends(l, &s);
    fraction_clear(&s.low);
    fraction_clear(&s.high);
}

/* The first plane that t is on; -1 for none. */
int plane_at(const line *l, const location *t)
{
    for (int i = 0; i < l->planes; i++) {
        if (location_sign(t, &l->inner[i]) == 0)
            return i;
    }
    return -1;
}

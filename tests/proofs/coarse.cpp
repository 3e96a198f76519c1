/* SPDX-License-Identifier: MIT */
/* The first stages in coarse arithmetic: every operation is off by 2^-36 of its result, and the
 * bounds count 2^-36 for one (coarse_bounds.py), so inputs where a rounding matters are met 65,000
 * times as often. The exact tier is the truth. No miss, part or error may be wrong. */
#include "coarse_bounds.h" /* in the place of surehit/bounds.h */
#include "hostile.hpp"
#include "truth.h"

#include <stdio.h>

static const double ROUNDING = 0x1p-36;
static enum { ANY, GREATER, LESS, FARTHER, NEARER, MODES } mode;
static std::mt19937 coin;

/* At random, greater or less, or farther from or nearer to 0. */
scalar computed(operation what, scalar, scalar, double exact)
{
    static unsigned tosses, left;
    if (what == NEGATION || what == MAGNITUDE || what == SIGNED)
        return exact;
    double off = ROUNDING * fabs(exact);
    switch (mode) {
    case GREATER: return exact + off;
    case LESS: return exact - off;
    case FARTHER: return exact * (1 + ROUNDING);
    case NEARER: return exact * (1 - ROUNDING);
    default: break;
    }
    if (left == 0)
        tosses = static_cast<unsigned>(coin()), left = 32;
    bool up = tosses & 1;
    tosses >>= 1;
    left--;
    return exact * (up ? 1 + ROUNDING : 1 - ROUNDING);
}

void compared(scalar, scalar)
{
}

struct account {
    const char *name;
    long asked, misses, chords, decided, wrong;
    double worst; /* |t - t*| over the error */
};

static void fault(account *of, const char *what, const double x[])
{
    if (of->wrong++ >= 3)
        return;
    printf("%s:%d:F:%s: %s:", __FILE__, __LINE__, of->name, what);
    for (int i = 0; i < INPUTS; i++)
        printf(" %a", x[i]);
    printf(" (mode %d)\n", mode);
}

static void check_chord(account *of, const filter_interval &found, const truth &true_one,
                        const double x[])
{
    const filter_end ends[] = {found.enter, found.leave};
    if (!true_one.meets)
        return fault(of, "a chord that is not there", x);
    for (int i = 0; i < 2; i++) {
        double share = fabs(ends[i].t.value - true_one.t[i]) / ends[i].error.value;
        of->worst = fmax(of->worst, share);
        if (!(share <= 1))
            fault(of, "t is off by more than the error", x);
        if (static_cast<int>(ends[i].end.part) != true_one.part[i])
            fault(of, "another part", x);
    }
}

/* What is made of the chord for the ray's range. */
static void check_first(account *of, const filter_interval &found, const sure_ray &ray,
                        const truth &true_one, const double x[])
{
    filter_end first;
    filter_verdict verdict = filter_first(&found, &ray, &first);
    if (verdict == FILTER_MISS && true_one.hits)
        fault(of, "a miss in the range that is a hit", x);
    if (verdict == FILTER_INTERVAL &&
        !(true_one.hits && static_cast<int>(first.end.part) == true_one.hit_part &&
          fabs(first.t.value - true_one.hit_t) <= first.error.value))
        fault(of, "another hit", x);
}

/* What single calls ask first, where that is not the filter. */
static decided decide(const sure_ray &ray, const sure_sphere &sphere)
{
    return sphere_decide(&ray, &sphere);
}
static decided decide(const sure_ray &ray, const sure_box &box)
{
    return box_decide(&ray, &box);
}
#define DECIDE(shape)                                                                              \
    static decided decide(const sure_ray &ray, const sure_##shape &s)                              \
    {                                                                                              \
        const axial_terms terms = shape##_terms_of(&ray, &s);                                      \
        const scalar discriminant = axial_discriminant(&terms);                                    \
        if (discriminant < 0 || !axial_is_certain(&terms, discriminant) ||                         \
            !axial_fits(&terms, s.radius))                                                         \
            return decided{};                                                                      \
        const shape##_ends ends = shape##_ends_of(&terms, discriminant, terms.inner);              \
        return axial_answer(&ends.line, terms.d_d, terms.size, &ray);                              \
    }
DECIDE(cylinder)
DECIDE(cone)
template <class object> static decided decide(const sure_ray &, const object &)
{
    return decided{};
}

static void check_decided(account *of, const query &q, const truth &true_one, const double x[])
{
    decided said = {};
    switch (q.object.shape) {
#define SAID(shape, SHAPE)                                                                         \
    case SURE_SHAPE_##SHAPE: said = decide(q.ray, q.object.as.shape); break;
        SURE_EACH_SHAPE(SAID)
    }
    of->decided += said.certain;
    if (said.certain && (said.meets != 0) != (true_one.hits != 0))
        fault(of, "a wrong decision", x);
    if (said.certain && said.meets && true_one.hits &&
        !(static_cast<int>(said.hit.part) == true_one.hit_part &&
          fabs(said.hit.t.value - true_one.hit_t) <= said.hit.t_error.value))
        fault(of, "another hit decided", x);
}

static void check(account *of, sure_shape shape, const double x[])
{
    bool line = shape_has(shape, SURE_KIND_NORMAL);
    scalar inputs[INPUTS];
    filter_interval found;
    truth true_one;
    for (int i = 0; i < INPUTS; i++)
        inputs[i] = x[i];
    if (!truth_of(x, shape, &true_one))
        return;
    for (int m = 0; m < MODES + 3; m++) {
        mode = m < MODES ? static_cast<decltype(mode)>(m) : ANY;
        of->asked++;
        query q = query_of(shape, inputs);
        filter_verdict verdict = filtered(q, &found);
        of->misses += verdict == FILTER_MISS;
        of->chords += verdict == FILTER_INTERVAL;
        if (verdict == FILTER_MISS && (line ? true_one.ahead : true_one.meets))
            fault(of, "a miss that is a hit", x);
        if (verdict == FILTER_INTERVAL) {
            check_chord(of, found, true_one, x);
            check_first(of, found, q.ray, true_one, x);
        }
        check_decided(of, q, true_one, x);
    }
}

int main(int count, char **arguments)
{
    long cases = count > 1 ? atol(arguments[1]) : 300000;
    bool good = true;
    setvbuf(stdout, nullptr, _IOLBF, 0);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        account of = {sure_shape_name(static_cast<sure_shape>(shape)), 0, 0, 0, 0, 0, 0};
        hostile draw(static_cast<unsigned>(shape + 1));
        double x[INPUTS];
        for (long i = 0; i < cases; i++) {
            draw.query(static_cast<sure_shape>(shape), 20, 44, x);
            check(&of, static_cast<sure_shape>(shape), x);
        }
        if (of.misses < of.asked / 50 || of.chords < of.asked / 50)
            fault(&of, "next to nothing is told", x);
        printf("%-8s asked %ld: %ld misses, %ld chords, %ld decided, error/bound of t %.3f, "
               "%ld wrong\n",
               of.name, of.asked, of.misses, of.chords, of.decided, of.worst, of.wrong);
        good = good && of.wrong == 0;
    }
    printf(good ? "1 passed, 0 failed\n" : "0 passed, 1 failed\n");
    return good ? 0 : 1;
}

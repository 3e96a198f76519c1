#include "shape_laws.h"

#include <fenv.h>
#include <math.h>
#include <string.h>

typedef struct {
    sure_status status;
    sure_hit hit;
    sure_vec3 normal;
    bool ranged; /* something over- or underflowed on the way */
} outcome;

static outcome ask(const sure_case *question, sure_tier tier)
{
    outcome o = {0};
    fenv_t kept;
    feholdexcept(&kept);
    o.status = sure_object_hit(&question->ray, &question->object, tier, &o.hit);
    if (o.status == SURE_HIT)
        o.normal = sure_object_normal(&question->ray, &question->object, tier, &o.hit);
    o.ranged = fetestexcept(FE_OVERFLOW | FE_UNDERFLOW) != 0;
    fesetenv(&kept);
    return o;
}

static bool same_vector(sure_vec3 a, sure_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Is `moved` the outcome `plain` with t times t_factor? */
static bool same_outcome(const outcome *plain, const outcome *moved, double t_factor,
                         sure_vec3 expected_normal)
{
    if (plain->status != moved->status)
        return false;
    return plain->status != SURE_HIT ||
           (moved->hit.t == plain->hit.t * t_factor && moved->hit.part == plain->hit.part &&
            same_vector(moved->normal, expected_normal));
}

/* Multiplies numbers first..last-1 by 2^k; false where that is not exact. */
static bool scaled(double *numbers, int first, int last, int k)
{
    for (int i = first; i < last; i++) {
        double x = ldexp(numbers[i], k);
        if (ldexp(x, -k) != numbers[i])
            return false;
        numbers[i] = x;
    }
    return true;
}

enum { ORIGIN = 0, DIRECTION = 3, T_MIN = 6, T_MAX = 7, OBJECT = 8 };

/* Law 1: scaling origin, object and t range by 2^k. The normal of a plane or disc is a length too,
 * and may be scaled or not. */
static bool law_scale(const sure_case *question, sure_tier tier, const outcome *plain,
                      unsigned long *checked)
{
    static const int powers[] = {-40, -3, 1, 17};
    sure_shape shape = question->object.shape;
    for (size_t i = 0; i < sizeof powers / sizeof *powers; i++) {
        double numbers[CASE_NUMBERS_MAX];
        case_to_numbers(question, numbers);
        if (!scaled(numbers, ORIGIN, DIRECTION, powers[i]) ||
            !scaled(numbers, T_MIN, OBJECT, powers[i]) ||
            !scaled(numbers, OBJECT, case_numbers(shape), powers[i]))
            continue;
        sure_case moved = case_from_numbers(shape, numbers);
        outcome o = ask(&moved, tier);
        if (plain->ranged || o.ranged)
            continue;
        ++*checked;
        if (!same_outcome(plain, &o, ldexp(1, powers[i]), plain->normal))
            return false;
    }
    return true;
}

/* Law 2: d -> 2^k d with the t range 2^-k. */
static bool law_direction(const sure_case *question, sure_tier tier, const outcome *plain,
                          unsigned long *checked)
{
    static const int powers[] = {-30, 1, 8};
    sure_shape shape = question->object.shape;
    for (size_t i = 0; i < sizeof powers / sizeof *powers; i++) {
        double numbers[CASE_NUMBERS_MAX];
        case_to_numbers(question, numbers);
        if (!scaled(numbers, DIRECTION, T_MIN, powers[i]) ||
            !scaled(numbers, T_MIN, OBJECT, -powers[i]))
            continue;
        sure_case moved = case_from_numbers(shape, numbers);
        outcome o = ask(&moved, tier);
        if (plain->ranged || o.ranged)
            continue;
        ++*checked;
        if (!same_outcome(plain, &o, ldexp(1, -powers[i]), plain->normal))
            return false;
    }
    return true;
}

/* Law 3: negating one coordinate of everything, or exchanging x and y. Vectors stand at 0, 3, 8
 * and, but for the sphere, 11. */
static void each_vector(sure_shape shape, double *numbers, void (*change)(double *vector, int axis),
                        int axis)
{
    change(numbers + ORIGIN, axis);
    change(numbers + DIRECTION, axis);
    change(numbers + OBJECT, axis);
    if (shape != SURE_SHAPE_SPHERE)
        change(numbers + OBJECT + 3, axis);
}

static void negate_coordinate(double *vector, int axis)
{
    vector[axis] = -vector[axis];
}

static void exchange_xy(double *vector, int unused)
{
    (void)unused;
    double x = vector[0];
    vector[0] = vector[1];
    vector[1] = x;
}

static bool law_mirror(const sure_case *question, sure_tier tier, const outcome *plain,
                       unsigned long *checked)
{
    sure_shape shape = question->object.shape;
    for (int axis = 0; axis <= 3; axis++) {
        void (*change)(double *, int) = axis < 3 ? negate_coordinate : exchange_xy;
        double numbers[CASE_NUMBERS_MAX];
        case_to_numbers(question, numbers);
        each_vector(shape, numbers, change, axis);
        sure_case moved = case_from_numbers(shape, numbers);
        outcome o = ask(&moved, tier);
        double normal[3] = {plain->normal.x, plain->normal.y, plain->normal.z};
        change(normal, axis);
        ++*checked;
        if (!same_outcome(plain, &o, 1, (sure_vec3){normal[0], normal[1], normal[2]}))
            return false;
    }
    return true;
}

/* Law 4: occluded's status is hit's; a hit's t is an end of the chord, or t_min inside one that
 * lies in the boundary. */
static bool law_questions_agree(const sure_case *question, sure_tier tier, const outcome *plain)
{
    sure_interval chord;
    sure_status interval =
        sure_object_interval(&question->ray, &question->object, tier, &chord);
    if (sure_object_occluded(&question->ray, &question->object, tier) != plain->status)
        return false;
    if ((interval == SURE_INVALID) != (plain->status == SURE_INVALID))
        return false;
    if (interval == SURE_HIT && !(chord.t_enter <= chord.t_leave))
        return false;
    if (plain->status != SURE_HIT)
        return true;
    double t = plain->hit.t, t_min = question->ray.t_min;
    if (interval != SURE_HIT)
        return false;
    if (t == chord.t_enter)
        return plain->hit.part == chord.enter_part;
    if (t == chord.t_leave)
        return plain->hit.part == chord.leave_part;
    return t == (tier == SURE_TIER_FLOAT32 ? (float)t_min : t_min) && chord.t_enter < t &&
           t < chord.t_leave;
}

/* Law 5: on miss and invalid no output is touched; invalid exactly when check names a field. */
static bool law_untouched(const sure_case *question, sure_tier tier)
{
    sure_hit hit, hit_before;
    sure_interval chord, chord_before;
    memset(&hit, 0xa5, sizeof hit);
    memset(&chord, 0xa5, sizeof chord);
    hit_before = hit;
    chord_before = chord;
    sure_status status = sure_object_hit(&question->ray, &question->object, tier, &hit);
    sure_status interval =
        sure_object_interval(&question->ray, &question->object, tier, &chord);
    bool valid = sure_object_check(&question->ray, &question->object) == SURE_FIELD_NONE;
    return (status == SURE_INVALID) == !valid &&
           (status == SURE_HIT || memcmp(&hit, &hit_before, sizeof hit) == 0) &&
           (interval == SURE_HIT || memcmp(&chord, &chord_before, sizeof chord) == 0);
}

/* Law 6: widening [t_min, t_max] never turns a hit into a miss. */
static bool law_wider(const sure_case *question, sure_tier tier, const outcome *plain)
{
    sure_case wider = *question;
    wider.ray.t_min = 0;
    wider.ray.t_max = INFINITY;
    return plain->status != SURE_HIT || ask(&wider, tier).status == SURE_HIT;
}

/* Law 7: t lies in [t_min, t_max] of the tier's precision. The normal is a unit vector as far as
 * that shows without a tolerance: no component beyond 1, the largest not below 1/2, none a NaN. */
static bool law_in_range(const sure_case *question, sure_tier tier, const outcome *plain)
{
    double t_min = question->ray.t_min, t_max = question->ray.t_max;
    if (tier == SURE_TIER_FLOAT32) {
        t_min = (float)t_min;
        t_max = (float)t_max;
    }
    if (plain->status != SURE_HIT)
        return true;
    sure_vec3 n = plain->normal;
    double largest = fmax(fabs(n.x), fmax(fabs(n.y), fabs(n.z)));
    bool unit = fabs(n.x) <= 1 && fabs(n.y) <= 1 && fabs(n.z) <= 1 && largest >= 0.5;
    return t_min <= plain->hit.t && plain->hit.t <= t_max && unit;
}

const char *shape_law_broken(const sure_case *question, sure_tier tier, unsigned long *checked)
{
    outcome plain = ask(question, tier);
    *checked += 4;
    if (!law_untouched(question, tier))
        return "Law 5: outputs untouched on miss and invalid, invalid when check says so";
    if (!law_questions_agree(question, tier, &plain))
        return "Law 4: hit, interval and occluded agree";
    if (!law_wider(question, tier, &plain))
        return "Law 6: a wider t range keeps the hit";
    if (!law_in_range(question, tier, &plain))
        return "Law 7: t in its range, the normal a unit vector";
    if (plain.status == SURE_INVALID)
        return NULL;
    if (!law_scale(question, tier, &plain, checked))
        return "Law 1: scaling origin, object and t range by a power of two";
    if (!law_direction(question, tier, &plain, checked))
        return "Law 2: scaling the direction by a power of two";
    if (!law_mirror(question, tier, &plain, checked))
        return "Law 3: negating a coordinate or exchanging x and y";
    return NULL;
}

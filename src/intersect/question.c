#include "question.h"

#include <string.h>

/* A ray and an object as doubles in the order of their fields, and what each of these is: a Length,
 * part of the Direction or of the Normal, or t. */
enum { RAY_NUMBERS = 8, NUMBERS = 15 };
static const char kinds_of[SURE_SHAPES][NUMBERS + 1] = {
    "LLLDDDttLLLNNN", "LLLDDDttLLLNNNL", "LLLDDDttLLLL", "LLLDDDttLLLLLLL", "LLLDDDttLLLLLLL"};
static const int count_of[SURE_SHAPES] = {6, 7, 4, 7, 7};

_Static_assert(sizeof(sure_ray) == 8 * sizeof(double), "a ray is eight doubles");
_Static_assert(sizeof(sure_plane) == 6 * sizeof(double), "a plane is six doubles");
_Static_assert(sizeof(sure_disc) == 7 * sizeof(double), "a disc is seven doubles");
_Static_assert(sizeof(sure_sphere) == 4 * sizeof(double), "a sphere is four doubles");
_Static_assert(sizeof(sure_cylinder) == 7 * sizeof(double), "a cylinder is seven doubles");
_Static_assert(sizeof(sure_cone) == 7 * sizeof(double), "a cone is seven doubles");

static bool is_ordinary(double x)
{
    const uint64_t least = bits_of(0x1p-30), most = bits_of(0x1p30);
    return magnitude_bits(x) - least <= most - least || is_zero_bits(x);
}

/* e with 2^e <= |x| < 2^(e+1), subnormal x too. */
static int true_exponent(double x)
{
    if (exponent_of(x) > -1023)
        return exponent_of(x);
    magnitude_parts parts = parts_of(x);
    return exponent_of((double)parts.mantissa) + parts.exponent;
}

/* x 2^k, x not zero and the result in the normal range. */
static double shifted(double x, int k)
{
    if (exponent_of(x) > -1023)
        return double_of(bits_of(x) + ((uint64_t)k << 52));
    magnitude_parts parts = parts_of(x);
    uint64_t bits = bits_of((double)parts.mantissa);
    bits += (uint64_t)(parts.exponent + k) << 52;
    return double_of(bits | (bits_of(x) & BITS_SIGN));
}

/* The exponent of the largest of one kind; 0 when all are zero. */
static int largest_exponent(const double numbers[], const char kinds[], char kind)
{
    uint64_t largest = 0;
    for (int i = 0; kinds[i] != 0; i++) {
        if (kinds[i] == kind && magnitude_bits(numbers[i]) > largest)
            largest = magnitude_bits(numbers[i]);
    }
    return largest == 0 ? 0 : true_exponent(double_of(largest));
}

/* Scales the numbers of one kind so that their largest is in [1, 2), and says by which power of
 * two. */
static bool scale(double numbers[], const char kinds[], char kind, int *exponent)
{
    int largest = largest_exponent(numbers, kinds, kind);
    *exponent = largest;
    for (int i = 0; kinds[i] != 0; i++) {
        if (kinds[i] != kind || is_zero_bits(numbers[i]))
            continue;
        if (true_exponent(numbers[i]) - largest < -QUESTION_SPREAD)
            return false;
        numbers[i] = shifted(numbers[i], -largest);
    }
    return true;
}

/* What is out of any stage's range stays so. */
static double scaled_t(double t, int k)
{
    const int beyond = 400;
    if (is_zero_bits(t) || !is_finite_bits(t))
        return t;
    int exponent = true_exponent(t) + k;
    if (exponent > beyond || exponent < -beyond)
        return power_of_two(exponent > 0 ? beyond : -beyond);
    return shifted(t, k);
}

static bool scale_question(double numbers[NUMBERS], question *q)
{
    sure_shape shape = q->object->shape;
    const char *kinds = kinds_of[shape];
    int unit, step, unused;
    if (!scale(numbers, kinds, 'L', &unit) || !scale(numbers, kinds, 'D', &step) ||
        !scale(numbers, kinds, 'N', &unused))
        return false;
    q->t_exponent = unit - step;
    q->length_exponent = unit;
    numbers[6] = scaled_t(q->asked->t_min, -q->t_exponent);
    numbers[7] = scaled_t(q->asked->t_max, -q->t_exponent);
    q->scaled_object.shape = shape;
    memcpy(&q->scaled_ray, numbers, sizeof q->scaled_ray);
    memcpy(&q->scaled_object.as, numbers + RAY_NUMBERS, (size_t)count_of[shape] * sizeof *numbers);
    q->ray = &q->scaled_ray;
    q->object = &q->scaled_object;
    return true;
}

bool question_of(const sure_ray *ray, const sure_object *object, question *q)
{
    double numbers[NUMBERS];
    int count = count_of[object->shape];
    bool ordinary = true;
    memcpy(numbers, ray, sizeof *ray);
    memcpy(numbers + RAY_NUMBERS, &object->as, (size_t)count * sizeof *numbers);
    q->asked = q->ray = ray;
    q->object = object;
    q->t_exponent = q->length_exponent = 0;
    for (int i = 0; i < RAY_NUMBERS + count && ordinary; i++)
        ordinary = is_ordinary(numbers[i]) || i == 6 || i == 7;
    return ordinary || scale_question(numbers, q);
}

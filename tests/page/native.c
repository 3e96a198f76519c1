/* SPDX-License-Identifier: MIT */
/* What the native library answers, in doubles, for who is to answer the same:
 *
 *     native SHAPE TIER COUNT
 *
 * so many cases of each regime: 8 numbers of the ray, the object's, then status, part, leaves, t,
 * t_error and the normal, or zeros where there is none.
 *
 *     native SHAPE TIER COUNT time
 *
 * prints nanoseconds a ray of so many cases of the regime typical, the least of some rounds. */
#include "../../src/cases/regimes.h"
#include "../../src/support/cpu_time.h"

#include <surehit/many.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    double status, part, leaves, t, t_error, normal[3];
} told;

static told answer(const sure_case *question, sure_tier tier)
{
    sure_hit hit;
    sure_status status = sure_object_hit(&question->ray, &question->object, tier, &hit);
    if (status != SURE_HIT)
        return (told){.status = status};
    sure_vec3 n = sure_object_normal(&question->ray, &question->object, tier, &hit);
    return (told){status, hit.part, hit.leaves, hit.t, hit.t_error, {n.x, n.y, n.z}};
}

static void write_all(sure_shape shape, sure_tier tier, uint64_t count)
{
    for (int which = 0; which < REGIMES; which++) {
        for (uint64_t i = 0; i < count && regime_applies(shape, (regime)which); i++) {
            const sure_case question = regime_case(shape, (regime)which, 0, i);
            const told is = answer(&question, tier);
            double numbers[CASE_NUMBERS_MAX];
            case_to_numbers(&question, numbers);
            fwrite(numbers, sizeof *numbers, (size_t)case_numbers(shape), stdout);
            fwrite(&is, sizeof is, 1, stdout);
        }
    }
}

#define ROUNDS 15

static void print_time(sure_shape shape, sure_tier tier, size_t count)
{
    sure_case *cases = malloc(count * sizeof *cases);
    double *t = malloc(5 * count * sizeof *t), least = 1e9;
    uint8_t *bytes = malloc(3 * count);
    if (!cases || !t || !bytes)
        exit(1);
    const ptrdiff_t stride = sizeof *cases, number = sizeof *t;
    for (size_t i = 0; i < count; i++)
        cases[i] = regime_case(shape, REGIME_TYPICAL, 0, i);
    const sure_rays rays = sure_rays_of(&cases->ray, stride);
    const sure_objects objects = sure_objects_of(shape, &cases->object.as, stride);
    const sure_hits to = {.status = {bytes, 1},
                          .part = {bytes + count, 1},
                          .leaves = {bytes + 2 * count, 1},
                          .t = {t, number},
                          .t_error = {t + count, number}};
    for (int round = 0; round < ROUNDS; round++) {
        double started = cpu_time();
        sure_objects_hits(count, &rays, &objects, tier, &to);
        double took = (cpu_time() - started) / (double)count;
        least = took < least ? took : least;
    }
    printf("%.2f\n", least);
    free(cases);
    free(t);
    free(bytes);
}

int main(int argc, char **argv)
{
    sure_shape shape;
    sure_tier tier;
    if (argc < 4 || !sure_shape_from_name(argv[1], &shape) || !sure_tier_from_name(argv[2], &tier))
        return 2;
    unsigned long count = strtoul(argv[3], NULL, 10);
    if (argc > 4)
        print_time(shape, tier, count);
    else
        write_all(shape, tier, count);
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* What a call for many rays takes above a loop of single calls that does the same: a row a shape,
 * nanoseconds a ray by tier certain and textbook, in turns. `meson compile check-many`. */
#include "../../src/cases/regimes.h"

#include <surehit/many.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define MOST 15 /* nanoseconds a ray above the loop */

/* Rays that stay in the second cache, as often as it takes to be sure of the least time. */
enum { COUNT = 4096, ROUNDS = 300 };

typedef struct {
    uint8_t status[COUNT], part[COUNT], leaves[COUNT];
    double t[COUNT], t_error[COUNT];
    sure_vec3 normal[COUNT];
} answers;

static sure_ray rays[COUNT];
static sure_object object;
static answers alone, many;

/* The loop calls the functions of a shape, as who has but one would. */
#define LOOP(shape, SHAPE, tier)                                                                   \
    static void loop_##shape##_##tier(void)                                                        \
    {                                                                                              \
        const sure_##shape *const of = &object.as.shape;                                           \
        for (int i = 0; i < COUNT; i++) {                                                          \
            sure_hit hit;                                                                          \
            alone.status[i] = (uint8_t)sure_##shape##_hit_##tier(&rays[i], of, &hit);              \
            if (alone.status[i] != SURE_HIT)                                                       \
                continue;                                                                          \
            alone.part[i] = (uint8_t)hit.part;                                                     \
            alone.leaves[i] = (uint8_t)hit.leaves;                                                 \
            alone.t[i] = hit.t;                                                                    \
            alone.t_error[i] = hit.t_error;                                                        \
            alone.normal[i] = sure_##shape##_normal_##tier(&rays[i], of, &hit);                    \
        }                                                                                          \
    }                                                                                              \
    static void many_##shape##_##tier(void)                                                        \
    {                                                                                              \
        const sure_rays all = sure_rays_of(rays, sizeof *rays);                                    \
        const sure_hits hits = {{many.status, 1},                                                  \
                                {many.part, 1},                                                    \
                                {many.leaves, 1},                                                  \
                                {many.t, sizeof *many.t},                                          \
                                {many.t_error, sizeof *many.t_error},                              \
                                {{&many.normal[0].x, sizeof *many.normal},                         \
                                 {&many.normal[0].y, sizeof *many.normal},                         \
                                 {&many.normal[0].z, sizeof *many.normal}}};                       \
        sure_##shape##_hits_##tier(COUNT, &all, &object.as.shape, &hits);                          \
    }
#define LOOPS(shape, SHAPE) LOOP(shape, SHAPE, certain) LOOP(shape, SHAPE, textbook)
SURE_EACH_SHAPE(LOOPS)

typedef struct {
    void (*loop)(void), (*many)(void);
} pair;
#define PAIR(shape, SHAPE)                                                                         \
    {{loop_##shape##_certain, many_##shape##_certain},                                             \
     {loop_##shape##_textbook, many_##shape##_textbook}},
static const pair pairs[SURE_SHAPES][2] = {SURE_EACH_SHAPE(PAIR)};

static double nanoseconds(void (*run)(void))
{
    struct timespec before, after;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &before);
    run();
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &after);
    return ((double)(after.tv_sec - before.tv_sec) * 1e9 +
            (double)(after.tv_nsec - before.tv_nsec)) /
           COUNT;
}

/* The least of the rounds: what else runs adds, and takes nothing away. */
static double print_pair(const pair *of)
{
    double loop = INFINITY, all = INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
        loop = fmin(loop, nanoseconds(of->loop));
        all = fmin(all, nanoseconds(of->many));
    }
    printf("%8.1f %6.1f", loop, all - loop);
    if (memcmp(&alone, &many, sizeof alone) != 0) {
        fputs("\nother answers than the single calls'\n", stderr);
        exit(2);
    }
    return all - loop;
}

int main(void)
{
    double worst = -INFINITY;
    printf("%-10s%8s %6s%9s %6s\n", "shape", "certain", "above", "textbook", "above");
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        for (int i = 0; i < COUNT; i++) {
            const sure_case made = regime_case((sure_shape)shape, REGIME_TYPICAL, 1, (uint64_t)i);
            rays[i] = made.ray;
            if (i == 0)
                object = made.object;
        }
        printf("%-10s", sure_shape_name((sure_shape)shape));
        for (int tier = 0; tier < 2; tier++)
            worst = fmax(worst, print_pair(&pairs[shape][tier]));
        puts("");
    }
    printf("above the loop at most %.1f ns a ray: %s %d\n", worst,
           worst <= MOST ? "holds" : "DOES NOT HOLD", MOST);
    return worst > MOST;
}

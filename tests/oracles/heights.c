/* SPDX-License-Identifier: MIT */
/* How often the heights of cylinder and cone are told wrong, by how near the point is to the rim,
 * against the reference: docs/heights.csv. With that file as the argument it is compared. */
#include "objects.h"
#include "part_check.h"
#include "reference.h"
#include "rng.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 20000, TOLD = 4 };

/* Of the solid's height, away from the rim along the axis; 0: the doubles nearest to it. */
static const double distances[] = {1, 1e-6, 1e-12, 0};
static const sure_tier tiers[TOLD] = {SURE_TIER_FLOAT32, SURE_TIER_TEXTBOOK, SURE_TIER_CERTAIN,
                                      SURE_TIER_EXACT};

static sure_vec3 place(rng *g)
{
    double x = rng_between(g, -10, 10), y = rng_between(g, -10, 10);
    return (sure_vec3){x, y, rng_between(g, -10, 10)};
}

/* A solid of a size that scenes have, and a point at the rim of its base. */
static sure_object solid_of(sure_shape shape, rng *g, double distance, sure_vec3 *point)
{
    sure_vec3 base = place(g), up = rng_unit(g), any = rng_unit(g);
    double height = rng_between(g, 0.1, 10), radius = rng_between(g, 0.1, 10);
    sure_vec3 across = cross(up, any);
    double away = distance * rng_between(g, -1, 1) * height;
    *point = plus(plus(base, times(radius / sqrt(dot(across, across)), across)), times(away, up));
    return (sure_object){shape, {.cylinder = {base, plus(base, times(height, up)), radius}}};
}

static void count(FILE *file, sure_shape shape, int which)
{
    int wrong[TOLD] = {0};
    for (uint64_t i = 0; i < POINTS; i++) {
        rng g = rng_of(1, (uint64_t)shape, (uint64_t)which, i);
        sure_vec3 p;
        sure_object solid = solid_of(shape, &g, distances[which], &p);
        int right = reference_height(&solid, p);
        for (int t = 0; t < TOLD; t++)
            wrong[t] += height_of(&solid, p, tiers[t]) != right;
    }
    fprintf(file, "%s,%g,%d", sure_shape_name(shape), distances[which], POINTS);
    for (int t = 0; t < TOLD; t++)
        fprintf(file, ",%d", wrong[t]);
    fprintf(file, "\n");
}

static void write_rows(FILE *file)
{
    fprintf(file, "shape,distance,cases");
    for (int t = 0; t < TOLD; t++)
        fprintf(file, ",%s", sure_tier_name(tiers[t]));
    fprintf(file, "\n");
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (size_t d = 0; has_parts(shape) && d < sizeof distances / sizeof *distances; d++)
            count(file, shape, (int)d);
    }
}

int main(int argc, char **argv)
{
    char made[4096] = "", there[sizeof made] = "";
    FILE *rows = argc > 1 ? fmemopen(made, sizeof made, "w") : stdout;
    FILE *record = argc > 1 ? fopen(argv[1], "r") : NULL;
    if (!rows || (argc > 1 && !record))
        return 2;
    write_rows(rows);
    if (argc == 1)
        return EXIT_SUCCESS;
    fclose(rows);
    size_t size = fread(there, 1, sizeof there - 1, record);
    fclose(record);
    bool same = size == strlen(made) && memcmp(made, there, size) == 0;
    printf("%s%d passed, %d failed\n", same ? "" : made, same, !same);
    return same ? EXIT_SUCCESS : EXIT_FAILURE;
}

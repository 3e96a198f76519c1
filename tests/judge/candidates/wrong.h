/* SPDX-License-Identifier: MIT */
/* What the judge's candidates have in common: they do what the variable SUREHIT_WRONG names. */
#pragma once

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <surehit/candidate.h>
#include <surehit/object.h>

#ifdef FLOAT
typedef float real;
typedef sure_candidate_hit_float outputs;
#define nextreal nextafterf
#else
typedef double real;
typedef sure_candidate_hit outputs;
#define nextreal nextafter
#endif

/* Is this the first word? Then *named goes on behind it. */
static int is_first(const char **named, const char *word)
{
    size_t length = strlen(word);
    int is = *named && strncmp(*named, word, length) == 0;
    *named += is ? length : 0;
    return is;
}

static int is_wrong(const char *what)
{
    const char *named = getenv("SUREHIT_WRONG");
    (void)(is_first(&named, "always ") || is_first(&named, "rarely "));
    return named && strcmp(named, what) == 0;
}

/* One case in sixteen, or rarely in 32, whichever order they come in. */
static int is_now(const real *numbers, int count)
{
    const char *named = getenv("SUREHIT_WRONG");
    uint64_t sum = 0, bits;
    for (int i = 0; i < count; i++) {
        double number = numbers[i];
        memcpy(&bits, &number, sizeof bits);
        sum = (sum ^ bits) * UINT64_C(0x9e3779b97f4a7c15);
    }
    return is_first(&named, "always ") || sum >> (is_first(&named, "rarely ") ? 59 : 60) == 0;
}

static sure_vec3 vector(const real *from)
{
    return (sure_vec3){from[0], from[1], from[2]};
}

/* SUREHIT_RADIUS: the radius is larger by that share of it, always. */
static double larger(double radius)
{
    const char *share = getenv("SUREHIT_RADIUS");
    return share ? radius * (1 + atof(share)) : radius;
}

static sure_object object_of(sure_shape shape, const real *from)
{
    sure_object it = {.shape = shape};
    double numbers[SURE_SHAPE_NUMBERS];
    int count = sure_shape_info_of(shape)->numbers;
    for (int i = 0; i < count; i++)
        numbers[i] = from[i];
    numbers[count - 1] = larger(numbers[count - 1]);
    memcpy(&it.as, numbers, (size_t)count * sizeof *numbers);
    return it;
}

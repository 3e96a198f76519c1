/* SPDX-License-Identifier: MIT */
/* surehit-reference [--interval | --wall]: case lines in, the reference's answer lines out
 * (docs/contract.md), for `surehit judge --truth reference`; with --interval a hit is
 * `interval <t_enter> <t_leave>`, both ends of the chord, with --wall `hit <t> wall`, of the
 * infinite wall (of a shape that has one). It reads and writes them by itself: no
 * code of the library or the judge has a part in the truth. */
#include "reference.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LINE_MOST 4096
#define RAY_NUMBERS 8

/* The object's numbers stand behind those of the ray; a shape's struct is nothing else. */
#define NUMBERS_MOST (RAY_NUMBERS + sizeof(sure_object) / sizeof(double))
#define SHAPE(shape, SHAPE) [SURE_SHAPE_##SHAPE] = {#shape, sizeof(sure_##shape) / sizeof(double)},
static const struct {
    const char *name;
    size_t numbers;
} shapes[] = {SURE_EACH_SHAPE(SHAPE)};

#define PART(part, PART) [SURE_PART_##PART] = #part,
#define FIELD(field, FIELD) [SURE_FIELD_##FIELD] = #field,
static const char *const parts[] = {SURE_EACH_PART(PART)};
static const char *const fields[] = {SURE_EACH_FIELD(FIELD)};

/* The shape that the line begins with and a blank behind it, stepped over; -1 for none. */
static int take_shape(const char **at)
{
    for (int i = 0; i < SURE_SHAPES; i++) {
        size_t length = strlen(shapes[i].name);
        if (strncmp(*at, shapes[i].name, length) == 0 && (*at)[length] == ' ') {
            *at += length + 1;
            return i;
        }
    }
    return -1;
}

/* Numbers with one blank between, up to the line's end or a remark. */
static bool take_numbers(const char *at, double *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char *end;
        if (strchr(" \t\r\n\v\f", *at)) /* the end too; strtod would step over the others */
            return false;
        numbers[i] = strtod(at, &end);
        if (end == at || (i + 1 < count && *end != ' '))
            return false;
        at = end + (i + 1 < count);
    }
    return strcmp(at, "") == 0 || strcmp(at, "\n") == 0 || strcmp(at, "\r\n") == 0 ||
           strncmp(at, " #", 2) == 0;
}

static sure_status answer_hit(const sure_ray *ray, const sure_object *object)
{
    double t;
    sure_part part;
    sure_vec3 n;
    sure_status status = reference_hit(ray, object, &t, &part, &n);
    if (status == SURE_HIT)
        printf("hit %a %s %a %a %a\n", t, parts[part], n.x, n.y, n.z);
    return status;
}

static sure_status answer_interval(const sure_ray *ray, const sure_object *object)
{
    sure_interval chord;
    sure_status status = reference_interval(ray, object, &chord);
    if (status == SURE_HIT)
        printf("interval %a %a\n", chord.t_enter, chord.t_leave);
    return status;
}

static sure_status answer_wall(const sure_ray *ray, const sure_object *object)
{
    double t;
    sure_status status = reference_wall_hit(ray, object, &t);
    if (status == SURE_HIT)
        printf("hit %a wall\n", t);
    return status;
}

typedef sure_status answer(const sure_ray *ray, const sure_object *object);

static void answer_line(const char *line, answer *say)
{
    double numbers[NUMBERS_MOST];
    int shape = take_shape(&line);
    if (shape < 0 || !take_numbers(line, numbers, RAY_NUMBERS + shapes[shape].numbers)) {
        puts("invalid line");
        return;
    }
    sure_ray ray = {{numbers[0], numbers[1], numbers[2]},
                    {numbers[3], numbers[4], numbers[5]},
                    numbers[6],
                    numbers[7]};
    sure_object object = {.shape = (sure_shape)shape};
    memcpy(&object.as, numbers + RAY_NUMBERS, shapes[shape].numbers * sizeof *numbers);
    sure_status status = say(&ray, &object);
    if (status == SURE_MISS)
        puts("miss");
    else if (status == SURE_INVALID)
        printf("invalid %s\n", fields[reference_check(&ray, &object)]);
}

int main(int count, char **words)
{
    char line[LINE_MOST];
    bool interval = count == 2 && strcmp(words[1], "--interval") == 0;
    bool wall = count == 2 && strcmp(words[1], "--wall") == 0;
    if (count > 1 && !interval && !wall) {
        fputs("surehit-reference [--interval | --wall]\n", stderr);
        return 2;
    }
    while (fgets(line, sizeof line, stdin))
        answer_line(line, wall ? answer_wall : interval ? answer_interval : answer_hit);
    return fflush(stdout) == 0 && !ferror(stdout) ? EXIT_SUCCESS : EXIT_FAILURE;
}

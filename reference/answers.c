/* surehit-reference: case lines in, the reference's answer lines out (docs/contract.md), for
 * `surehit judge --truth reference`. It reads and writes them by itself: no code of the library or
 * the judge has a part in the truth. */
#include "reference.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LINE_MOST 4096
#define RAY_NUMBERS 8
#define NUMBERS_MOST 15

/* In the order of sure_shape; the numbers behind those of the ray. */
static const struct {
    const char *name;
    int numbers;
} shapes[SURE_SHAPES] = {{"plane", 6}, {"disc", 7}, {"sphere", 4}, {"cylinder", 7}, {"cone", 7}};

static const char *const parts[] = {"surface", "base", "top", "wall"};
static const char *const fields[] = {"none",   "o",    "d",      "t_min", "t_max", "point",
                                     "centre", "base", "normal", "top",   "apex",  "radius"};

static sure_vec3 vector(const double *from)
{
    return (sure_vec3){from[0], from[1], from[2]};
}

static sure_object object_of(sure_shape shape, const double *from)
{
    sure_object object = {.shape = shape};
    switch (shape) {
    case SURE_SHAPE_PLANE: object.as.plane = (sure_plane){vector(from), vector(from + 3)}; break;
    case SURE_SHAPE_DISC:
        object.as.disc = (sure_disc){vector(from), vector(from + 3), from[6]};
        break;
    case SURE_SHAPE_SPHERE: object.as.sphere = (sure_sphere){vector(from), from[3]}; break;
    case SURE_SHAPE_CYLINDER:
        object.as.cylinder = (sure_cylinder){vector(from), vector(from + 3), from[6]};
        break;
    case SURE_SHAPE_CONE:
        object.as.cone = (sure_cone){vector(from), vector(from + 3), from[6]};
        break;
    }
    return object;
}

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

/* Numbers with one blank between, up to the line's end. */
static bool take_numbers(const char *at, double *numbers, int count)
{
    for (int i = 0; i < count; i++) {
        char *end;
        if (strchr(" \t\r\n\v\f", *at)) /* the end too; strtod would step over the others */
            return false;
        numbers[i] = strtod(at, &end);
        if (end == at || (i + 1 < count && *end != ' '))
            return false;
        at = end + (i + 1 < count);
    }
    return strcmp(at, "") == 0 || strcmp(at, "\n") == 0 || strcmp(at, "\r\n") == 0;
}

static void answer(const sure_ray *ray, const sure_object *object)
{
    double t;
    sure_part part;
    sure_vec3 n;
    switch (reference_hit(ray, object, &t, &part, &n)) {
    case SURE_HIT: printf("hit %a %s %a %a %a\n", t, parts[part], n.x, n.y, n.z); break;
    case SURE_MISS: puts("miss"); break;
    case SURE_INVALID: printf("invalid %s\n", fields[reference_check(ray, object)]); break;
    }
}

static void answer_line(const char *line)
{
    double numbers[NUMBERS_MOST];
    int shape = take_shape(&line);
    if (shape < 0 || !take_numbers(line, numbers, RAY_NUMBERS + shapes[shape].numbers)) {
        puts("invalid line");
        return;
    }
    sure_ray ray = {vector(numbers), vector(numbers + 3), numbers[6], numbers[7]};
    sure_object object = object_of((sure_shape)shape, numbers + RAY_NUMBERS);
    answer(&ray, &object);
}

int main(void)
{
    char line[LINE_MOST];
    while (fgets(line, sizeof line, stdin))
        answer_line(line);
    return fflush(stdout) == 0 && !ferror(stdout) ? EXIT_SUCCESS : EXIT_FAILURE;
}

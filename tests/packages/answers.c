/* SPDX-License-Identifier: MIT */
/* For each case line of standard input the bits of all that each tier answers: the public headers
 * and nothing else. */
#include <surehit/surehit.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_MOST = 4096, NUMBERS = 8 }; /* numbers of a ray */

static void print_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    printf(" %016" PRIx64, bits);
}

static void print_vector(sure_vec3 v)
{
    print_bits(v.x);
    print_bits(v.y);
    print_bits(v.z);
}

static void answer(const sure_ray *ray, const sure_object *object, sure_tier tier)
{
    sure_hit hit;
    sure_interval chord;
    sure_status status = sure_object_hit(ray, object, tier, &hit);
    printf("%s %s %s", sure_shape_name(object->shape), sure_tier_name(tier),
           sure_status_name(status));
    if (status == SURE_HIT) {
        print_bits(hit.t);
        print_bits(hit.t_error);
        printf(" %s %d", sure_part_name(hit.part), hit.leaves);
        print_vector(sure_object_normal(ray, object, tier, &hit));
    }
    status = sure_object_interval(ray, object, tier, &chord);
    printf(" interval %s", sure_status_name(status));
    if (status == SURE_HIT) {
        print_bits(chord.t_enter);
        print_bits(chord.t_leave);
        printf(" %s %s", sure_part_name(chord.enter_part), sure_part_name(chord.leave_part));
    }
    printf(" occluded %s stage %s\n", sure_status_name(sure_object_occluded(ray, object, tier)),
           sure_stage_name(sure_object_stage(ray, object, tier)));
}

/* In floats, of the same query several times: one by one, or in a block. */
static void answer_floats(sure_shape shape, const float *ray, const float *object, size_t count)
{
    uint8_t status = 9, part = 9, leaves = 9;
    float t = 0, normal[3] = {0, 0, 0};
    const sure_rays rays = sure_rays_of_f(ray, 0);
    const sure_objects objects = sure_objects_of_f(shape, object, 0);
    const sure_hits hits = {{&status, 0}, {&part, 0},
                            {&leaves, 0}, {&t, 0},
                            {NULL, 0},    {{&normal[0], 0}, {&normal[1], 0}, {&normal[2], 0}}};
    sure_objects_hits_certain_f(count, &rays, &objects, &hits);
    printf(" %d %d %d", status, part, leaves);
    print_bits(t);
    for (int k = 0; k < 3; k++)
        print_bits(normal[k]);
}

/* The numbers of a line, of which there must be so many. */
static void take(char **at, double *numbers, int count)
{
    for (int i = 0; i < count; i++) {
        char *end;
        numbers[i] = strtod(*at, &end);
        if (end == *at) {
            fprintf(stderr, "no number: %s\n", *at);
            exit(2);
        }
        *at = end;
    }
}

int main(void)
{
    static char line[LINE_MOST];
    while (fgets(line, sizeof line, stdin)) {
        double r[NUMBERS], of[SURE_SHAPE_NUMBERS];
        sure_object object;
        char *at = strchr(line, ' ');
        if (at)
            *at++ = '\0';
        if (!at || !sure_shape_from_name(line, &object.shape)) {
            fprintf(stderr, "no shape: %s\n", line);
            return 2;
        }
        take(&at, r, NUMBERS);
        take(&at, of, sure_shape_info_of(object.shape)->numbers);
        memcpy(&object.as, of, sizeof *of * (size_t)sure_shape_info_of(object.shape)->numbers);
        sure_ray ray = {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, r[6], r[7]};
        for (int tier = 0; tier < SURE_TIERS; tier++)
            answer(&ray, &object, (sure_tier)tier);
        float r_f[NUMBERS], of_f[SURE_SHAPE_NUMBERS];
        for (int k = 0; k < NUMBERS; k++)
            r_f[k] = (float)r[k];
        for (int k = 0; k < sure_shape_info_of(object.shape)->numbers; k++)
            of_f[k] = (float)of[k];
        printf("%s floats", sure_shape_name(object.shape));
        answer_floats(object.shape, r_f, of_f, 1);
        answer_floats(object.shape, r_f, of_f, 9);
        printf("\n");
    }
    return 0;
}

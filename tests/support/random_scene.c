#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include "random_scene.h"

#include "rng.h"
#include "suite.h"

#include <stdio.h>

enum { SOLIDS = 40, PLANES = 2, LIGHTS = 3, STREAM = 707 };

typedef struct {
    FILE *out;
    rng stream;
} draw;

static int below(draw *d, int limit)
{
    return rng_integer(&d->stream, 0, limit - 1);
}

static double between(draw *d, double low, double high)
{
    return rng_between(&d->stream, low, high);
}

static double size(draw *d, int low, int high)
{
    return rng_magnitude(&d->stream, low, high);
}

static void write_vector(draw *d, double reach)
{
    double x = between(d, -reach, reach), y = between(d, -reach, reach);
    fprintf(d->out, " %a,%a,%a", x, y, between(d, -reach, reach));
}

/* Looks from the outskirts to about the middle. */
static void write_camera(draw *d)
{
    double eye[3], view[3];
    for (int axis = 0; axis < 3; axis++) {
        eye[axis] = between(d, -7, 7);
        view[axis] = between(d, -1, 1) - eye[axis];
    }
    fprintf(d->out, "C %a,%a,%a %a,%a,%a %a\n", eye[0], eye[1], eye[2], view[0], view[1], view[2],
            between(d, 40, 110));
}

static void write_color(draw *d)
{
    int red = 40 + below(d, 216), green = 40 + below(d, 216);
    fprintf(d->out, " %d,%d,%d", red, green, 40 + below(d, 216));
}

/* A third of the surfaces are mirrors, a sixth is clear. */
static void write_material(draw *d)
{
    write_color(d);
    fprintf(d->out, " spec:%a shine:%d", between(d, 0, 1), below(d, 100));
    int kind = below(d, 6);
    if (kind < 2)
        fprintf(d->out, " refl:%a", between(d, 0.2, 0.9));
    if (kind == 2)
        fprintf(d->out, " refr:%a", between(d, 1, 2));
    fputc('\n', d->out);
}

static void write_plane(draw *d)
{
    fputs("pl", d->out);
    write_vector(d, 9);
    write_vector(d, 1);
    write_material(d);
}

static void write_solid(draw *d)
{
    static const char *const names[] = {"sp", "cy", "co"};
    int kind = below(d, 3);
    fputs(names[kind], d->out);
    write_vector(d, 6);
    if (kind > 0)
        write_vector(d, 1);
    fprintf(d->out, " %a", size(d, -5, 2));
    if (kind > 0)
        fprintf(d->out, " %a", size(d, -5, 3));
    write_material(d);
}

static void write_options(draw *d)
{
    static const char *const cylinders[] = {"middle", "base"};
    static const char *const cones[] = {"middle", "base", "apex"};
    fprintf(d->out, "#! handedness %s\n", below(d, 2) ? "left" : "right");
    fprintf(d->out, "#! fov %s\n", below(d, 2) ? "vertical" : "horizontal");
    fprintf(d->out, "#! cylinder-position %s\n", cylinders[below(d, 2)]);
    fprintf(d->out, "#! cone-position %s\n", cones[below(d, 3)]);
}

static void write_lights(draw *d)
{
    bool falls = below(d, 2);
    fprintf(d->out, "falloff %s\n", falls ? "inverse-square" : "none");
    for (int i = 0; i < LIGHTS; i++) {
        fputc('L', d->out);
        write_vector(d, 8);
        fprintf(d->out, " %a", falls ? between(d, 50, 500) : between(d, 0.2, 0.8));
        write_color(d);
        fputc('\n', d->out);
    }
}

char *random_scene(uint64_t seed)
{
    char *text;
    size_t size;
    draw d = {open_memstream(&text, &size), rng_of(STREAM, 0, 0, seed)};
    ck_assert_ptr_nonnull(d.out);
    write_options(&d);
    fputs("A 0.15 255,255,255\n", d.out);
    write_camera(&d);
    write_lights(&d);
    for (int i = 0; i < PLANES; i++)
        write_plane(&d);
    for (int i = 0; i < SOLIDS; i++)
        write_solid(&d);
    ck_assert_int_eq(fclose(d.out), 0);
    return text;
}

/* SPDX-License-Identifier: MIT */
/* A renderer's own loop over its own things: what a pixel sees, and whether the lamp lights it.
 *
 * docs/your_renderer.md goes through it and says how it is compiled. */
#include <math.h>
#include <stdio.h>
#include <surehit/surehit.h>

typedef struct {
    sure_object body;
    char paint;
} thing;

static const thing things[] = {
    {{SURE_SHAPE_PLANE, .as.plane = {{0, -1, 0}, {0, 1, 0}}}, '-'},
    {{SURE_SHAPE_CYLINDER, .as.cylinder = {{-1.6, -1, -6}, {-1.6, 0.8, -6}, 0.9}}, '#'},
    {{SURE_SHAPE_SPHERE, .as.sphere = {{1.2, 0, -6}, 1}}, 'o'},
};
static const sure_vec3 lamp = {6, 8, 0};
enum { THINGS = sizeof things / sizeof *things, WIDTH = 64, HEIGHT = 16 };

/* The number of the first thing on the ray, or -1. Of two at one distance the earlier one. */
static int nearest(const sure_ray *ray, sure_hit *hit)
{
    int first = -1;
    for (int i = 0; i < THINGS; i++) {
        sure_hit here;
        const sure_object *body = &things[i].body;
        if (sure_object_hit(ray, body, SURE_TIER_CERTAIN, &here) == SURE_HIT &&
            (first < 0 || sure_hit_order(ray, body, &here, &things[first].body, hit) < 0)) {
            first = i;
            *hit = here;
        }
    }
    return first;
}

/* Does the lamp reach this hit? */
static int is_lit(const sure_ray *ray, const sure_object *body, const sure_hit *hit)
{
    sure_ray way = {.t_max = 1}; /* from beside the surface, 0, to the lamp, 1 */
    /* A plane or disc that may be seen from behind: the side is that of the sign of N.d. */
    if (!sure_spawn(ray, body, hit, hit->leaves ? SURE_SIDE_INSIDE : SURE_SIDE_OUTSIDE,
                    &way.origin))
        return 0;
    way.direction =
        (sure_vec3){lamp.x - way.origin.x, lamp.y - way.origin.y, lamp.z - way.origin.z};
    for (int i = 0; i < THINGS; i++)
        if (sure_object_occluded(&way, &things[i].body, SURE_TIER_CERTAIN) == SURE_HIT)
            return 0;
    return 1;
}

static char pixel(int x, int y)
{
    sure_ray ray = {.direction = {(x + 0.5 - WIDTH / 2) / 24, (7 - y - 0.5) / 12, -2},
                    .t_max = INFINITY};
    sure_hit hit;
    int seen = nearest(&ray, &hit);
    return seen < 0 ? '.' : is_lit(&ray, &things[seen].body, &hit) ? things[seen].paint : ':';
}

int main(void)
{
    static char picture[HEIGHT][WIDTH + 1];
#pragma omp parallel for
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            picture[y][x] = pixel(x, y);
    for (int y = 0; y < HEIGHT; y++)
        puts(picture[y]);
}

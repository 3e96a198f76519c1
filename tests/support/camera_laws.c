/* SPDX-License-Identifier: MIT */
#include "camera_laws.h"

#include "long_vector.h"
#include "tiers.h"

#include <stdint.h>
#include <string.h>

static bool same_matrix(const sure_mat3 *m, const sure_mat3 *n)
{
    return same_vector(m->row[0], n->row[0]) && same_vector(m->row[1], n->row[1]) &&
           same_vector(m->row[2], n->row[2]);
}

static sure_status (*const rotation[TIERS])(sure_vec3,
                                            sure_mat3 *) = OF_TIERS(sure_camera_rotation);

/* Straight along an axis every entry is exact: the notes' cases 1 to 6. True for another view. */
static bool is_axis_matrix(sure_vec3 v, const sure_mat3 *world)
{
    const sure_vec3 right = {1, 0, 0}, up = {0, 1, 0}, back = {0, 0, 1};
    const sure_vec3 left = {-1, 0, 0}, down = {0, -1, 0}, ahead = {0, 0, -1};
    sure_mat3 m;
    if ((v.x != 0) + (v.y != 0) + (v.z != 0) != 1)
        return true;
    if (v.x != 0)
        m = v.x > 0 ? (sure_mat3){{back, up, left}} : (sure_mat3){{ahead, up, right}};
    else if (v.y != 0)
        m = v.y > 0 ? (sure_mat3){{right, back, down}} : (sure_mat3){{right, ahead, up}};
    else
        m = v.z > 0 ? (sure_mat3){{left, up, ahead}} : (sure_mat3){{right, up, back}};
    return same_matrix(world, &m);
}

/* What makes it that rotation and no other: it takes the view to (0,0,-1); its rows are at right
 * angles and of length 1, and turn right; verticals stay vertical and up stays up. Each entry is
 * off by at most 11 u: 7 u a cosine (two squares, their sum, its root, 2 u, twice over, the
 * quotient), 3 u the other factor, u the product. */
#define ENTRY_ROUNDINGS 11

static const char *rotation_broken(sure_tier tier, sure_vec3 view, const sure_mat3 *world)
{
    /* A row's error is sqrt(3) times an entry's; a product of two rows has twice that. */
    const long double off = 2 * ENTRY_ROUNDINGS * unit(tier);
    const long_vector f = long_unit(long_of(view)), x = long_of(world->row[0]),
                      y = long_of(world->row[1]), z = long_of(world->row[2]);
    const long_vector rows[] = {x, y, z};
    const long_vector across = {x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z,
                                x.x * y.y - x.y * y.x};
    for (int i = 0; i < 3; i++) {
        if (!(fabsl(long_dot(rows[i], f) + (i == 2)) <= off))
            return "Law 4: the view does not become (0,0,-1)";
        for (int j = 0; j <= i; j++)
            if (!(fabsl(long_dot(rows[i], rows[j]) - (i == j)) <= 2 * off))
                return "Law 4: the rows are not a rotation's";
    }
    if (!(long_dot(across, z) > 0))
        return "Law 4: a reflection";
    if (!(fabsl(x.x * f.x + x.z * f.z) <= off * sqrtl(f.x * f.x + f.z * f.z)))
        return "Law 5: what lies to the right is not level with the view";
    return world->row[0].y == 0 && world->row[1].y >= 0 ? NULL : "Law 5: up does not stay up";
}

/* True where the tier's numbers don't hold the view times 2^k. */
static bool holds_law_2(sure_tier tier, sure_vec3 view, const sure_mat3 *world, int k)
{
    sure_vec3 scaled = times_two_to(view, k), of_tier = rounded_vector(tier, scaled);
    sure_mat3 other;
    if (!is_direction(of_tier) || !same_vector(times_two_to(of_tier, -k), view))
        return true;
    return rotation[tier](scaled, &other) == SURE_HIT && same_matrix(world, &other);
}

static bool holds_law_3(sure_tier tier, sure_vec3 v, const sure_mat3 *m)
{
    const sure_vec3 *r = m->row;
    sure_mat3 other,
        mirrored = {
            {{r[0].x, -r[0].y, -r[0].z}, {-r[1].x, r[1].y, r[1].z}, {-r[2].x, r[2].y, r[2].z}}};
    return rotation[tier]((sure_vec3){-v.x, v.y, v.z}, &other) == SURE_HIT &&
           same_matrix(&mirrored, &other);
}

const char *rotation_law_broken(sure_tier tier, sure_vec3 view, int k)
{
    sure_mat3 world, before;
    sure_vec3 v = rounded_vector(tier, view);
    memset(&before, 0xa5, sizeof before);
    memcpy(&world, &before, sizeof world);
    if (rotation[tier](view, &world) != (is_direction(v) ? SURE_HIT : SURE_INVALID))
        return "a wrong status";
    if (!is_direction(v))
        return memcmp(&world, &before, sizeof before) == 0 ? NULL : "written for an invalid view";
    if (!is_axis_matrix(v, &world))
        return "Law 1: an axis' matrix is not exact";
    if (!holds_law_2(tier, v, &world, k))
        return "Law 2: a power of two changes the matrix";
    if (!holds_law_3(tier, view, &world))
        return "Law 3: a mirrored view's matrix is not mirrored";
    return rotation_broken(tier, v, &world);
}

static sure_ray (*const pixel_ray[TIERS])(const sure_camera *, int, int, int,
                                          int) = OF_TIERS(sure_pixel_ray);

static sure_ray ray_through(const pixel *p, sure_tier tier, int column, int row)
{
    return pixel_ray[tier](&p->camera, p->width, p->height, column, row);
}

/* From the middle of the window to the middle of the pixel. Three roundings, and in float32 those
 * of both whole numbers and of the extent. */
static bool near_offset(sure_tier tier, double given, double size, int at, int of)
{
    long double right =
        (long double)rounded(tier, size) * (2 * (long double)at + 1 - of) / (2 * (long double)of);
    return fabsl(given - right) <= 5 * unit(tier) * fabsl(right) + least(tier);
}

const char *pixel_law_broken(sure_tier tier, const pixel *p)
{
    const sure_camera *camera = &p->camera;
    sure_ray ray = ray_through(p, tier, p->column, p->row);
    sure_vec3 d = ray.direction;
    if (!same_vector(ray.origin, rounded_vector(tier, camera->position)))
        return "the ray starts elsewhere";
    if (ray.t_min != 0 || ray.t_max != INFINITY)
        return "a range that is not [0, infinity]";
    if (d.z != -rounded(tier, camera->focal_length))
        return "the window is elsewhere";
    if (!near_offset(tier, d.x, camera->viewport_width, p->column, p->width) ||
        !near_offset(tier, d.y, camera->viewport_height, p->row, p->height))
        return "not through the pixel's middle";
    sure_vec3 across = ray_through(p, tier, p->width - 1 - p->column, p->row).direction;
    sure_vec3 upwards = ray_through(p, tier, p->column, p->height - 1 - p->row).direction;
    if (!same_vector(across, (sure_vec3){-d.x, d.y, d.z}) ||
        !same_vector(upwards, (sure_vec3){d.x, -d.y, d.z}))
        return "Law 1: mirrored pixels' rays are not mirrored";
    bool middle = 2 * (int64_t)p->column + 1 == p->width && 2 * (int64_t)p->row + 1 == p->height;
    if (middle && (d.x != 0 || d.y != 0))
        return "Law 2: the middle pixel is not straight ahead";
    if (p->column + 1 < p->width && d.x > ray_through(p, tier, p->column + 1, p->row).direction.x)
        return "the next pixel is not farther right";
    return NULL;
}

/* SPDX-License-Identifier: MIT */
/* A photon's weight is its share of the light's power, times the number of photons:
 *
 *     a light of power p_i = brightness mean(color) is chosen with probability p_i / sum p
 *     weight = color brightness / (p_i / sum p) = color / mean(color) sum p
 *     a matte surface: goes on with probability q, the colour's greatest part, weight color / q
 *     no fall-off: weight 4 pi length^2, once, on the first matte surface
 *
 * The eye E looks through the window, f away, whose pixels have the area A. A point P, z deep in
 * what it sees, is seen on the window at f / z times its offset from the axis.
 *
 *     pinhole:  a surface dA at P, its normal N, covers (N.(E - P)) f^2 / z^3 dA of the window
 *               share = (N.(E - P)) f^2 / (z^3 A)
 *     opening:  radiance L carries L f^2 / rho^4 dA_w dA_o through window and opening, which the
 *               photon crosses rho = f |d| / d_z apart
 *               share = rho^4 / (f^2 A R^2) = (f |d|^2 / d_z^2)^2 / (A R^2) */
#include <surehit/forward.h>

#include "photon.h"

#include <surehit/hit_order.h>
#include <surehit/rotation.h>

#include <assert.h>
#include <math.h>

/* What all photons have in common. */
typedef struct {
    tracing t;
    const sure_forward_options *options;
    sure_forward_splat splat;
    void *film;
    sure_forward_statistics *statistics;
} forward_pass;

/* Where light passes the window, and what one unit of it adds to that pixel. */
typedef struct {
    int column, row;
    double share;
} forward_mark;

/* Into the eye. */

/* From the eye, as the camera has it: to the right, up, and back. */
static sure_vec3 from_eye(const sure_scene *scene, sure_vec3 p)
{
    return sure_rotation_apply_textbook(&scene->turn, difference_of(p, scene->camera.position));
}

static double squared(double x)
{
    return x * x;
}

static double pixel_area(const sure_scene *scene)
{
    const sure_camera *camera = &scene->camera;
    return camera->viewport_width / scene->width * (camera->viewport_height / scene->height);
}

/* The pixel at (x, y) from the window's middle; false beside the window. */
static bool pixel_at(const sure_scene *scene, double x, double y, forward_mark *mark)
{
    double across = (x / scene->camera.viewport_width + 0.5) * scene->width;
    double up = (y / scene->camera.viewport_height + 0.5) * scene->height;
    if (!(across >= 0 && across < scene->width && up >= 0 && up < scene->height))
        return false;
    mark->column = (int)across;
    mark->row = (int)up;
    return true;
}

/* Is the point, lit on the normal's side, before the pinhole, on the side that the eye is on and
 * within the window's frame? Whether anything is in between is not asked. */
static bool forward_faces(const sure_scene *scene, const meeting *at, forward_mark *mark)
{
    const sure_camera *camera = &scene->camera;
    sure_vec3 seen = from_eye(scene, at->point);
    double depth = -seen.z;
    double facing = dot(at->normal, difference_of(camera->position, at->point));
    if (!(depth > 0 && facing > 0))
        return false;
    double reduced = camera->focal_length / depth;
    mark->share = facing * squared(reduced) / depth / pixel_area(scene);
    return pixel_at(scene, seen.x * reduced, seen.y * reduced, mark);
}

/* A number that can be added up, whatever the scene. */
static double amount(double light)
{
    if (!(light > 0))
        return 0;
    return light < DBL_MAX ? light : DBL_MAX;
}

/* Draws what so much light adds. */
static void forward_draw(const forward_pass *pass, const forward_mark *mark, sure_vec3 light)
{
    sure_vec3 value = {amount(light.x * mark->share), amount(light.y * mark->share),
                       amount(light.z * mark->share)};
    pass->splat(pass->film, mark->column, mark->row, value);
}

/* Where a ray that goes towards the eye crosses the window; false where it doesn't. */
static bool crosses_window(const forward_pass *pass, const sure_ray *ray, double *t,
                           forward_mark *mark)
{
    const sure_scene *scene = pass->t.scene;
    const sure_camera *camera = &scene->camera;
    sure_vec3 o = from_eye(scene, ray->origin);
    sure_vec3 d = sure_rotation_apply_textbook(&scene->turn, ray->direction);
    double ahead = -camera->focal_length - o.z;
    if (!(ahead >= 0 && d.z > 0))
        return false;
    double slant = dot(d, d) / squared(d.z);
    *t = ahead / d.z;
    mark->share = squared(camera->focal_length * slant) /
                  (pixel_area(scene) * squared(pass->options->aperture));
    return pixel_at(scene, o.x + *t * d.x, o.y + *t * d.y, mark);
}

/* Does the ray come from the front into the opening, before it meets anything? From its plane it
 * doesn't: what the eye touches is not in front of it. */
static bool is_let_in(const forward_pass *pass, const sure_ray *ray, const sure_nearest *nearest)
{
    const sure_scene *scene = pass->t.scene;
    const sure_object opening = {
        .shape = SURE_SHAPE_DISC,
        .as.disc = {scene->camera.position, scene->turn.row[2], pass->options->aperture},
    };
    sure_hit hit;
    if (!(from_eye(scene, ray->origin).z < 0) ||
        sure_object_hit(ray, &opening, pass->t.tier, &hit) != SURE_HIT)
        return false;
    if (!nearest)
        return true;
    if (!is_sure(pass->t.tier))
        return hit.t < nearest->hit.t;
    return sure_hit_order(ray, &opening, &hit, &scene->objects[nearest->object], &nearest->hit) < 0;
}

/* Does the photon enter the opening before it meets `nearest` (or NULL)? Draws it unless `light` is
 * NULL, and counts `through` and `reached`. */
static bool forward_enters(const forward_pass *pass, const sure_ray *ray,
                           const sure_nearest *nearest, const sure_vec3 *light)
{
    forward_mark mark;
    double t;
    bool enters = is_let_in(pass, ray, nearest);
    if (!crosses_window(pass, ray, &t, &mark))
        return enters;
    pass->statistics->through += enters || !nearest || t < nearest->hit.t;
    pass->statistics->reached += enters;
    if (enters && light)
        forward_draw(pass, &mark, *light);
    return enters;
}

/* On its way. */

/* Where a photon's way ends, or (TRAVELS) doesn't yet. */
typedef enum { TRAVELS, ESCAPED, ABSORBED, STOPPED, ENTERED } fate;

/* A light, by its power; NULL where none has any. */
static const sure_light *chosen_light(const sure_scene *scene, double total, random_stream *random)
{
    const sure_light *chosen = NULL;
    double left = random_fraction(random) * total;
    for (size_t i = 0; i < scene->light_count; i++) {
        double power = power_of(&scene->lights[i]);
        if (!(power > 0))
            continue;
        chosen = &scene->lights[i];
        left -= power;
        if (left < 0)
            break;
    }
    return chosen;
}

static bool leave_light(photon *p)
{
    double total = total_power(p->t.scene);
    const sure_light *light = chosen_light(p->t.scene, total, &p->random);
    if (!light)
        return false;
    p->weight = scaled(total / mean(light->color), light->color);
    photon_head_for(p, light->position, random_direction(&p->random));
    return true;
}

/* By the cosine law alone: as bright at any distance. */
static void undo_falloff(photon *p)
{
    if (!p->scattered && p->t.scene->falloff == SURE_FALLOFF_NONE)
        p->weight = scaled(4 * pi * p->length * p->length, p->weight);
}

/* Joins the point to the eye. */
static void show(const forward_pass *pass, const sure_surface_point *from, const forward_mark *mark,
                 sure_vec3 light)
{
    if (!shadow_reaches(&pass->t, from, pass->t.scene->camera.position))
        return;
    pass->statistics->reached++;
    forward_draw(pass, mark, light);
}

/* By the cosine law: to a point of the unit sphere that touches the surface, seen from where it
 * touches. Not where the surface has no side by its normal. */
static fate scatter(photon *p, sure_vec3 normal)
{
    double square = dot(normal, normal);
    sure_vec3 direction;
    if (!(square > 0 && square < INFINITY))
        return STOPPED;
    do
        direction = add(normal, random_direction(&p->random));
    while (!(dot(normal, direction) > 0));
    p->at_light = false;
    p->scattered = true;
    p->chain_left = p->t.scene->depth;
    photon_head_for(p, p->from.point, direction);
    return TRAVELS;
}

/* A matte surface shows what it is lit by; then it takes the photon in or sends it on, which for a
 * pinhole is of use only where it may light another one. */
static fate light_up(const forward_pass *pass, photon *p, const meeting *at)
{
    bool pinhole = !(pass->options->aperture > 0);
    forward_mark mark;
    if (p->surfaces_left <= 0)
        return STOPPED;
    p->surfaces_left--;
    pass->statistics->lit++;
    undo_falloff(p);
    const sure_vec3 color = at->material->color, light = product(color, p->weight);
    double share = fmax(color.x, fmax(color.y, color.z));
    bool survives = random_fraction(&p->random) < share;
    bool goes_on = survives && !(pinhole && p->surfaces_left <= 0);
    bool faces = pinhole && forward_faces(p->t.scene, at, &mark);
    pass->statistics->through += faces;
    bool left = (faces || goes_on) && meeting_leave(&p->t, at, at->side, &p->from);
    if (faces && left)
        show(pass, &p->from, &mark, light);
    if (!survives)
        return ABSORBED;
    if (!goes_on || !left)
        return STOPPED;
    p->weight = scaled(1 / share, light);
    return scatter(p, at->normal);
}

/* To the next surface, and what becomes of it there. */
static fate travel(const forward_pass *pass, photon *p)
{
    sure_nearest nearest;
    bool met = photon_nearest(p, &nearest);
    if (pass->options->aperture > 0 &&
        forward_enters(pass, &p->ray, met ? &nearest : NULL, p->scattered ? &p->weight : NULL))
        return ENTERED;
    if (!met)
        return ESCAPED;
    meeting at = photon_meet(p, &nearest);
    double mirror = at.material->mirror;
    if (meeting_is_clear(&at))
        return photon_pass_clear(p, &at) ? TRAVELS : STOPPED;
    /* The last mirror that is followed is matte, as to backward. */
    if (mirror > 0 && p->chain_left > 0 && random_fraction(&p->random) < mirror)
        return photon_reflect(p, &at) ? TRAVELS : STOPPED;
    return light_up(pass, p, &at);
}

static void count(sure_forward_statistics *statistics, fate end)
{
    statistics->emitted++;
    statistics->escaped += end == ESCAPED;
    statistics->absorbed += end == ABSORBED;
    statistics->stopped += end == STOPPED;
    statistics->entered += end == ENTERED;
}

void sure_forward_photon(const sure_scene *scene, sure_tier tier,
                         const sure_forward_options *options, uint64_t number,
                         sure_forward_splat splat, void *film, sure_forward_statistics *statistics)
{
    assert(options->bounces >= 1 && options->aperture >= 0 && isfinite(options->aperture));
    assert(scene->falloff != SURE_FALLOFF_NONE || options->bounces == 1);
    const forward_pass pass = {{scene, tier, NULL, NULL}, options, splat, film, statistics};
    photon p = {
        .t = pass.t,
        .random = random_stream_of(options->seed, RANDOM_PHOTON, number),
        .at_light = true,
        .chain_left = scene->depth,
        .surfaces_left = options->bounces,
    };
    fate end = TRAVELS;
    if (!leave_light(&p))
        return;
    while (end == TRAVELS)
        end = travel(&pass, &p);
    count(statistics, end);
}

/* All of it is counts. */
void sure_forward_statistics_add(sure_forward_statistics *sum, const sure_forward_statistics *more)
{
    const uint64_t *from = &more->emitted;
    for (size_t i = 0; i < sizeof *sum / sizeof *from; i++)
        (&sum->emitted)[i] += from[i];
}

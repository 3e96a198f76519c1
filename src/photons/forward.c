/* A photon's weight is its share of the light's power, times the number of photons:
 *
 *     a light of power p_i = brightness mean(color) is chosen with probability p_i / sum p
 *     weight = color brightness / (p_i / sum p) = color / mean(color) sum p
 *     a matte surface: goes on with probability q, the colour's greatest part, weight color / q
 *     no fall-off: weight 4 pi length^2, once, on the first matte surface */
#include "../geometry/sums.h"

#include "forward_eye.h"
#include "power.h"

#include "../support/random.h"
#include "../tracer/shadow.h"
#include "../tracer/visible.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/* Where a photon's way ends, or (TRAVELS) doesn't yet. */
typedef enum { TRAVELS, ESCAPED, ABSORBED, STOPPED, ENTERED } fate;

/* A photon before the next surface. */
typedef struct {
    const forward_pass *pass;
    random_stream random;
    sure_vec3 weight;
    sure_ray ray;
    sure_surface_point from;
    bool at_light;     /* comes from the light itself, not from a surface */
    bool scattered;    /* by a matte surface */
    double length;     /* of the way from the light, until it is scattered */
    int chain_left;    /* mirrors and clear surfaces that it may follow before the next matte one */
    int surfaces_left; /* matte ones that it may light */
} photon;

static double largest(sure_vec3 color)
{
    double of_two = color.x > color.y ? color.x : color.y;
    return of_two > color.z ? of_two : color.z;
}

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

static void head_for(photon *p, sure_vec3 origin, sure_vec3 direction)
{
    p->ray = (sure_ray){origin, direction, 0, INFINITY};
}

static bool leave_light(photon *p)
{
    const sure_scene *scene = p->pass->t.scene;
    double total = total_power(scene);
    const sure_light *light = chosen_light(scene, total, &p->random);
    if (!light)
        return false;
    p->weight = scaled(total / mean(light->color), light->color);
    head_for(p, light->position, random_direction(&p->random));
    return true;
}

/* The surface sends it on as it is, or in its own colour. */
static fate follow(photon *p, const meeting *at, sure_side side, sure_vec3 direction)
{
    if (!meeting_leave(&p->pass->t, at, side, &p->from))
        return STOPPED;
    p->chain_left--;
    p->at_light = false;
    head_for(p, p->from.point, direction);
    return TRAVELS;
}

/* One of the two ways on, by chance. */
static fate pass_clear(photon *p, const meeting *at)
{
    if (p->chain_left <= 0)
        return STOPPED;
    parting into = meeting_part(at);
    if (random_fraction(&p->random) < into.share)
        return follow(p, at, at->side, meeting_reflect(at));
    p->weight = product(at->material->color, p->weight);
    return follow(p, at, meeting_beyond(at), into.direction);
}

/* By the cosine law: a point of the unit sphere that touches the surface, seen from where it
 * touches. False where the surface has no side by its normal. */
static bool scatter(photon *p, sure_vec3 normal, sure_vec3 *direction)
{
    double square = dot(normal, normal);
    if (!(square > 0 && square < INFINITY))
        return false;
    do {
        sure_vec3 v = random_direction(&p->random);
        *direction = (sure_vec3){normal.x + v.x, normal.y + v.y, normal.z + v.z};
    } while (!(dot(normal, *direction) > 0));
    return true;
}

/* By the cosine law alone: as bright at any distance. */
static void undo_falloff(photon *p)
{
    if (!p->scattered && p->pass->t.scene->falloff == SURE_FALLOFF_NONE)
        p->weight = scaled(4 * pi * p->length * p->length, p->weight);
}

/* Joins the point to the eye. */
static void show(const photon *p, const sure_surface_point *from, const forward_mark *mark,
                 sure_vec3 light)
{
    const forward_pass *pass = p->pass;
    if (!shadow_reaches(&pass->t, from, pass->t.scene->camera.position))
        return;
    pass->statistics->reached++;
    forward_draw(pass, mark, light);
}

static fate send_on(photon *p, const meeting *at)
{
    sure_vec3 direction;
    if (!scatter(p, at->normal, &direction))
        return STOPPED;
    p->at_light = false;
    p->scattered = true;
    p->chain_left = p->pass->t.scene->depth;
    head_for(p, p->from.point, direction);
    return TRAVELS;
}

/* A matte surface shows what it is lit by; then it takes the photon in or sends it on, which for a
 * pinhole is of use only where it may light another one. */
static fate light_up(photon *p, const meeting *at)
{
    const forward_pass *pass = p->pass;
    bool pinhole = !(pass->options->aperture > 0);
    forward_mark mark;
    if (p->surfaces_left <= 0)
        return STOPPED;
    p->surfaces_left--;
    pass->statistics->lit++;
    undo_falloff(p);
    sure_vec3 light = product(at->material->color, p->weight);
    double share = largest(at->material->color);
    bool survives = random_fraction(&p->random) < share;
    bool goes_on = survives && !(pinhole && p->surfaces_left <= 0);
    bool faces = pinhole && forward_faces(pass->t.scene, at, &mark);
    pass->statistics->through += faces;
    bool left = (faces || goes_on) && meeting_leave(&pass->t, at, at->side, &p->from);
    if (faces && left)
        show(p, &p->from, &mark, light);
    if (!survives)
        return ABSORBED;
    if (!goes_on || !left)
        return STOPPED;
    p->weight = scaled(1 / share, light);
    return send_on(p, at);
}

static fate meet(photon *p, const meeting *at)
{
    double mirror = at->material->mirror;
    if (meeting_is_clear(at))
        return pass_clear(p, at);
    /* The last mirror that is followed is matte, as to backward. */
    if (mirror > 0 && p->chain_left > 0 && random_fraction(&p->random) < mirror)
        return follow(p, at, at->side, meeting_reflect(at));
    return light_up(p, at);
}

/* To the next surface. */
static fate travel(photon *p)
{
    const tracing *t = &p->pass->t;
    const sure_surface_point *leaving = p->at_light ? NULL : &p->from;
    sure_nearest nearest;
    bool met = visible_nearest(t->scene, t->tier, &p->ray, leaving, &nearest) == SURE_HIT;
    if (p->pass->options->aperture > 0 &&
        forward_enters(p->pass, &p->ray, met ? &nearest : NULL, p->scattered ? &p->weight : NULL))
        return ENTERED;
    if (!met)
        return ESCAPED;
    meeting at = meeting_of(t, &p->ray, leaving, &nearest);
    p->length += nearest.hit.t * sqrt(dot(p->ray.direction, p->ray.direction));
    return meet(p, &at);
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
    const forward_pass pass = {{scene, tier, NULL}, options, splat, film, statistics};
    photon p = {
        .pass = &pass,
        .random = random_stream_of(options->seed, RANDOM_PHOTON, number),
        .at_light = true,
        .chain_left = scene->depth,
        .surfaces_left = options->bounces,
    };
    fate end = TRAVELS;
    if (!leave_light(&p))
        return;
    while (end == TRAVELS)
        end = travel(&p);
    count(statistics, end);
}

void sure_forward_statistics_add(sure_forward_statistics *sum, const sure_forward_statistics *more)
{
    sum->emitted += more->emitted;
    sum->escaped += more->escaped;
    sum->absorbed += more->absorbed;
    sum->stopped += more->stopped;
    sum->entered += more->entered;
    sum->lit += more->lit;
    sum->through += more->through;
    sum->reached += more->reached;
}

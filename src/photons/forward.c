/* A photon's weight is its share of the light's power, times the number of photons:
 *
 *     a light of power p_i = brightness mean(color) is chosen with probability p_i / sum p
 *     weight = color brightness / (p_i / sum p) = color / mean(color) sum p
 *     a matte surface: goes on with probability q, the colour's greatest part, weight color / q
 *     no fall-off: weight 4 pi length^2, once, on the first matte surface */
#include "forward_eye.h"
#include "photon.h"
#include "power.h"

#include "../tracer/shadow.h"

/* Where a photon's way ends, or (TRAVELS) doesn't yet. */
typedef enum { TRAVELS, ESCAPED, ABSORBED, STOPPED, ENTERED } fate;

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
    sure_vec3 light = product(at->material->color, p->weight);
    double share = largest(at->material->color);
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
    const forward_pass pass = {{scene, tier, NULL}, options, splat, film, statistics};
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

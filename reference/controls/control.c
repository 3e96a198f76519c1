/* SPDX-License-Identifier: MIT */
/* What an interface alone costs: a routine that is handed local coordinates and keeps no more of
 * the object than its sizes, as those of many libraries are, and is right about what it is handed
 * (the tier exact). Under its entry conditions it has to be right everywhere: what the judge finds
 * wrong here would be the judge's fault, or the conditions'. */
#include "../peers/peer.h"

#include <surehit/surehit.h>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;
const char sure_candidate_entry[] = "unit local t_min=0";

/* With -DCONTROL_POINTS it is handed the ends of a segment: their rounding turns the ray. */
#ifdef CONTROL_POINTS
enum { BY_POINTS = 1 };
#else
enum { BY_POINTS = 0 };
#endif

static int answer(const real *ray, sure_object object, peer_hit *hit)
{
    const real way = BY_POINTS ? ray[7] : 1;
    real along[3];
    for (int i = 0; i < 3; i++) {
        const real end = ray[i] + way * ray[3 + i];
        along[i] = BY_POINTS ? end - ray[i] : ray[3 + i];
    }
    const sure_ray asked = {
        {ray[0], ray[1], ray[2]}, {along[0], along[1], along[2]}, 0, ray[7] / way};
    sure_hit found;
    sure_status status = sure_object_hit(&asked, &object, SURE_TIER_EXACT, &found);
    if (status != SURE_HIT)
        return (int)status;
    hit->t = (real)(found.t * way);
    hit->part = (int)found.part;
    return SURE_CANDIDATE_HIT;
}

int PEER(plane)(const real *ray, const real *plane, peer_hit *hit)
{
    (void)plane;
    return answer(ray, (sure_object){SURE_SHAPE_PLANE, {.plane = {{0, 0, 0}, {0, 0, 1}}}}, hit);
}

int PEER(disc)(const real *ray, const real *disc, peer_hit *hit)
{
    const sure_disc of = {{0, 0, 0}, {0, 0, 1}, disc[6]};
    return answer(ray, (sure_object){SURE_SHAPE_DISC, {.disc = of}}, hit);
}

int PEER(sphere)(const real *ray, const real *sphere, peer_hit *hit)
{
    const sure_sphere of = {{0, 0, 0}, sphere[3]};
    return answer(ray, (sure_object){SURE_SHAPE_SPHERE, {.sphere = of}}, hit);
}

int PEER(cylinder)(const real *ray, const real *cylinder, peer_hit *hit)
{
    const sure_cylinder of = {{0, 0, 0}, {0, 0, cylinder[5]}, cylinder[6]};
    return answer(ray, (sure_object){SURE_SHAPE_CYLINDER, {.cylinder = of}}, hit);
}

int PEER(cone)(const real *ray, const real *cone, peer_hit *hit)
{
    const sure_cone of = {{0, 0, 0}, {0, 0, cone[5]}, cone[6]};
    return answer(ray, (sure_object){SURE_SHAPE_CONE, {.cone = of}}, hit);
}

int PEER(box)(const real *ray, const real *box, peer_hit *hit)
{
    const sure_box of = {{0, 0, 0}, {box[3], box[4], box[5]}};
    return answer(ray, (sure_object){SURE_SHAPE_BOX, {.box = of}}, hit);
}

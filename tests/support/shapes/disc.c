/* Disc. */
#include "../test_shape.h"

static sure_object through(sure_vec3 p, double half, double s, bool cap)
{
    const sure_vec3 place = {p.x + (half - 3 * s), p.y - 4 * s, p.z - 2 * s};
    (void)cap;
    return object_made(SURE_SHAPE_DISC, place, (sure_vec3){4, -3, 0}, place, 64 * s);
}

static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    (void)ray;
    return object_sided(object);
}

static true_frame frame(const sure_object *object)
{
    const sure_disc *s = &object->as.disc;
    return (true_frame){
        .from = s->centre, .to = s->normal, .radius = s->radius, .flat = true, .round = true};
}

static int hull(const sure_object *object, hull_piece pieces[2])
{
    const sure_disc *s = &object->as.disc;
    pieces[0] =
        (hull_piece){.centre = s->centre, .to = s->normal, .radius = s->radius, .disc = true};
    return 1;
}

const test_shape test_shape_disc = {
    .through = through,
    .companion = companion,
    .frame = frame,
    .in_object = true_in_plane,
    .hull = hull,
};

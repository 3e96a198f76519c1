/* Plane. */
#include "../test_shape.h"

static sure_object through(sure_vec3 p, double half, double s, bool cap)
{
    const sure_vec3 place = {p.x + (half - 3 * s), p.y - 4 * s, p.z - 2 * s};
    (void)cap;
    return object_made(SURE_SHAPE_PLANE, place, (sure_vec3){4, -3, 0}, place, 64 * s);
}

static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    const sure_plane *s = &object->as.plane;
    (void)ray;
    return (sure_object){SURE_SHAPE_DISC, {.disc = {s->point, s->normal, 0x1p500}}};
}

static true_frame frame(const sure_object *object)
{
    const sure_plane *s = &object->as.plane;
    return (true_frame){.from = s->point, .to = s->normal, .flat = true};
}

static int hull(const sure_object *object, hull_piece pieces[2])
{
    (void)object;
    (void)pieces;
    return 0;
}

const test_shape test_shape_plane = {
    .through = through,
    .companion = companion,
    .frame = frame,
    .in_object = true_in_plane,
    .hull = hull,
};

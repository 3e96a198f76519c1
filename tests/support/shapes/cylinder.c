/* Cylinder. */
#include "../test_shape.h"

static sure_object through(sure_vec3 p, double half, double s, bool cap)
{
    const double x = p.x + (half - 3 * s), y = p.y - 4 * s;
    return object_made(SURE_SHAPE_CYLINDER, (sure_vec3){x, y, p.z - (cap ? 0 : 4 * s)}, p,
                       (sure_vec3){x, y, p.z + 8 * s}, (cap ? 10 : 5) * s);
}

static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    const sure_cylinder *s = &object->as.cylinder;
    (void)ray;
    return object_made(SURE_SHAPE_CYLINDER, s->base, s->base, vector_sum(2, s->top, -1, s->base),
                       s->radius);
}

static true_frame frame(const sure_object *object)
{
    const sure_cylinder *s = &object->as.cylinder;
    return (true_frame){s->base, s->base, s->top, s->radius, .round = true, .capped = true};
}

static int hull(const sure_object *object, hull_piece pieces[2])
{
    const sure_cylinder *s = &object->as.cylinder;
    pieces[0] = (hull_piece){s->base, s->base, s->top, s->radius, true};
    pieces[1] = (hull_piece){s->top, s->base, s->top, s->radius, true};
    return 2;
}

const test_shape test_shape_cylinder = {
    .through = through,
    .companion = companion,
    .frame = frame,
    .in_object = true_in_capped,
    .hull = hull,
};

/* Cone. */
#include "../test_shape.h"

static sure_object through(sure_vec3 p, double half, double s, bool cap)
{
    const double x = p.x + (half - 3 * s), y = p.y - 4 * s;
    return object_made(SURE_SHAPE_CONE, (sure_vec3){x, y, p.z - (cap ? 0 : 8 * s)}, p,
                       (sure_vec3){x, y, p.z + 8 * s}, 10 * s);
}

static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    const sure_cone *s = &object->as.cone;
    (void)ray;
    return object_made(SURE_SHAPE_CONE, vector_sum(2, s->base, -1, s->apex), s->apex, s->apex,
                       2 * s->radius);
}

static true_frame frame(const sure_object *object)
{
    const sure_cone *s = &object->as.cone;
    return (true_frame){s->apex,       s->apex,        s->base,       s->radius,
                        .round = true, .capped = true, .tapers = true};
}

static int hull(const sure_object *object, hull_piece pieces[2])
{
    const sure_cone *s = &object->as.cone;
    pieces[0] = (hull_piece){s->base, s->apex, s->base, s->radius, true};
    pieces[1] = (hull_piece){.centre = s->apex};
    return 2;
}

const test_shape test_shape_cone = {
    .through = through,
    .companion = companion,
    .frame = frame,
    .in_object = true_in_capped,
    .hull = hull,
    .long_numbers = true,
};

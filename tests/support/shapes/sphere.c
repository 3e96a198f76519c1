/* Sphere. */
#include "../objects.h"
#include "../test_shape.h"

static sure_object through(sure_vec3 p, double half, double s, bool cap)
{
    const sure_vec3 place = {p.x + (half - 3 * s), p.y - 2 * s, p.z - 6 * s};
    (void)cap;
    return object_made(SURE_SHAPE_SPHERE, place, place, place, 7 * s);
}

/* The cylinder that has the same section with the plane of centre and ray. */
static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    const sure_sphere *s = &object->as.sphere;
    sure_vec3 across = cross(ray->direction, minus(ray->origin, s->centre));
    return (sure_object){
        SURE_SHAPE_CYLINDER,
        {.cylinder = {minus(s->centre, across), plus(s->centre, across), s->radius}}};
}

static true_frame frame(const sure_object *object)
{
    const sure_sphere *s = &object->as.sphere;
    return (true_frame){.from = s->centre, .radius = s->radius, .round = true};
}

static int hull(const sure_object *object, hull_piece pieces[2])
{
    const sure_sphere *s = &object->as.sphere;
    pieces[0] = (hull_piece){.centre = s->centre, .radius = s->radius};
    return 1;
}

const test_shape test_shape_sphere = {
    .through = through,
    .companion = companion,
    .frame = frame,
    .in_object = true_in_body,
    .hull = hull,
};

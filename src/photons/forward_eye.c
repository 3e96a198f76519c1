/* The eye E looks along (0, 0, -1) through the window, f away, whose pixels have the area A. A
 * point P has the depth z = E_z - P_z and is seen on the window at f / z times its offset from the
 * axis.
 *
 *     pinhole:  a surface dA at P, its normal N, covers (N.(E - P)) f^2 / z^3 dA of the window
 *               share = (N.(E - P)) f^2 / (z^3 A)
 *     opening:  radiance L carries L f^2 / rho^4 dA_w dA_o through window and opening, which the
 *               photon crosses rho = f |d| / d_z apart
 *               share = rho^4 / (f^2 A R^2) = (f |d|^2 / d_z^2)^2 / (A R^2) */
#include "../numbers/bits.h"

#include "forward_eye.h"

#include "../tracer/visible.h"

#include <surehit/hit_order.h>

#include <float.h>

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

bool forward_faces(const sure_scene *scene, const meeting *at, forward_mark *mark)
{
    const sure_camera *camera = &scene->camera;
    const sure_vec3 *n = &at->normal;
    sure_vec3 to_eye = {camera->position.x - at->point.x, camera->position.y - at->point.y,
                        camera->position.z - at->point.z};
    double depth = to_eye.z;
    double facing = n->x * to_eye.x + n->y * to_eye.y + n->z * to_eye.z;
    if (!(depth > 0 && facing > 0))
        return false;
    double reduced = camera->focal_length / depth;
    mark->share = facing * squared(reduced) / depth / pixel_area(scene);
    return pixel_at(scene, -to_eye.x * reduced, -to_eye.y * reduced, mark);
}

/* A number that can be added up, whatever the scene. */
static double amount(double light)
{
    if (!(light > 0))
        return 0;
    return light < DBL_MAX ? light : DBL_MAX;
}

void forward_draw(const forward_pass *pass, const forward_mark *mark, sure_vec3 light)
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
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    double ahead = camera->position.z - camera->focal_length - o->z;
    if (!(ahead >= 0 && d->z > 0))
        return false;
    double slant = (d->x * d->x + d->y * d->y + d->z * d->z) / squared(d->z);
    *t = ahead / d->z;
    mark->share = squared(camera->focal_length * slant) /
                  (pixel_area(scene) * squared(pass->options->aperture));
    return pixel_at(scene, o->x + *t * d->x - camera->position.x,
                    o->y + *t * d->y - camera->position.y, mark);
}

/* Does the ray come from the front into the opening, before it meets anything? From its plane it
 * doesn't: what the eye touches is not in front of it. */
static bool is_let_in(const forward_pass *pass, const sure_ray *ray, const sure_nearest *nearest)
{
    const sure_scene *scene = pass->t.scene;
    const sure_vec3 eye = scene->camera.position;
    const sure_object opening = {
        .shape = SURE_SHAPE_DISC,
        .as.disc = {eye, {0, 0, 1}, pass->options->aperture},
    };
    sure_hit hit;
    if (!(ray->origin.z < eye.z) || sure_object_hit(ray, &opening, pass->t.tier, &hit) != SURE_HIT)
        return false;
    if (!nearest)
        return true;
    if (!is_sure(pass->t.tier))
        return hit.t < nearest->hit.t;
    return sure_hit_order(ray, &opening, &hit, &scene->objects[nearest->object], &nearest->hit) < 0;
}

bool forward_enters(const forward_pass *pass, const sure_ray *ray, const sure_nearest *nearest,
                    const sure_vec3 *light)
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

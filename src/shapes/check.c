#include "check.h"

sure_field sure_ray_check(const sure_ray *ray)
{
    return ray_field(ray);
}

sure_field sure_plane_check(const sure_ray *ray, const sure_plane *plane)
{
    return plane_field(ray, plane);
}

sure_field sure_disc_check(const sure_ray *ray, const sure_disc *disc)
{
    return disc_field(ray, disc);
}

sure_field sure_sphere_check(const sure_ray *ray, const sure_sphere *sphere)
{
    return sphere_field(ray, sphere);
}

sure_field sure_cylinder_check(const sure_ray *ray, const sure_cylinder *cylinder)
{
    return cylinder_field(ray, cylinder);
}

sure_field sure_cone_check(const sure_ray *ray, const sure_cone *cone)
{
    return cone_field(ray, cone);
}

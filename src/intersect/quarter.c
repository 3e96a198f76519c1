#include "quarter.h"

#include "../arithmetic/environment.h"
#include "solve.h"

static bool by_near(const sure_ray *ray, sure_shape shape, const void *object, near *value)
{
    return shape == SURE_SHAPE_SPHERE     ? solve_sphere_quarter_near(ray, object, value)
           : shape == SURE_SHAPE_CYLINDER ? solve_cylinder_quarter_near(ray, object, value)
                                          : solve_cone_quarter_near(ray, object, value);
}

static bool by_residue(const sure_ray *ray, sure_shape shape, const void *object, near *value)
{
    return shape == SURE_SHAPE_SPHERE     ? solve_sphere_quarter_residue(ray, object, value)
           : shape == SURE_SHAPE_CYLINDER ? solve_cylinder_quarter_residue(ray, object, value)
                                          : solve_cone_quarter_residue(ray, object, value);
}

bool quarter_of(const sure_ray *ray, sure_shape shape, const void *object, quarter *found)
{
    near value;
    bool told;
    found->stage = SURE_STAGE_DOUBLE_DOUBLE;
    TO_NEAREST(told, by_near(ray, shape, object, &value));
    if (!told) {
        found->stage = SURE_STAGE_RESIDUE;
        TO_NEAREST(told, by_residue(ray, shape, object, &value));
    }
    found->value = value.hi;
    found->error = (value.error + fabs(value.lo)) * (1 + 0x1p-50);
    return told;
}

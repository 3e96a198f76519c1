#include "lattice.h"

#include <math.h>
#include <string.h>

#define ORIGINS 125
#define DIRECTIONS 26
#define RADII 3
#define AXES 5

static const int axes[AXES][3] = {{0, 0, 1}, {0, 2, 0}, {1, 0, -1}, {1, 1, 1}, {2, -1, 0}};

static int radii(sure_shape shape)
{
    return shape == SURE_SHAPE_PLANE ? 1 : RADII;
}

uint64_t lattice_count(sure_shape shape)
{
    int objects = radii(shape) * (shape == SURE_SHAPE_SPHERE ? 1 : AXES);
    return (uint64_t)(ORIGINS * DIRECTIONS * objects);
}

static int take(uint64_t *index, int count)
{
    int taken = (int)(*index % (uint64_t)count);
    *index /= (uint64_t)count;
    return taken;
}

lattice_case lattice_member(sure_shape shape, uint64_t index)
{
    bool sphere = shape == SURE_SHAPE_SPHERE;
    lattice_case c = {.shape = shape, .anchor = {0, sphere, 0}};
    int direction = take(&index, DIRECTIONS);
    if (direction >= DIRECTIONS / 2)
        direction++; /* past zero */
    for (int i = 0; i < 3; i++) {
        c.origin[i] = take(&index, 5) - 2;
        c.direction[i] = direction % 3 - 1;
        direction /= 3;
    }
    c.radius = take(&index, radii(shape));
    if (!sphere)
        memcpy(c.axis, axes[take(&index, AXES)], sizeof c.axis);
    return c;
}

static sure_vec3 vector_of(const int v[3])
{
    return (sure_vec3){v[0], v[1], v[2]};
}

sure_case lattice_question(const lattice_case *c, int t_min, int t_max)
{
    sure_vec3 anchor = vector_of(c->anchor), axis = vector_of(c->axis);
    sure_vec3 end = {anchor.x + axis.x, anchor.y + axis.y, anchor.z + axis.z};
    double limit = t_max < 0 ? (double)INFINITY : t_max;
    sure_case question = {
        .ray = {vector_of(c->origin), vector_of(c->direction), t_min, limit},
        .object.shape = c->shape,
    };
    switch (c->shape) {
    case SURE_SHAPE_PLANE: question.object.as.plane = (sure_plane){anchor, axis}; break;
    case SURE_SHAPE_DISC: question.object.as.disc = (sure_disc){anchor, axis, c->radius}; break;
    case SURE_SHAPE_SPHERE: question.object.as.sphere = (sure_sphere){anchor, c->radius}; break;
    case SURE_SHAPE_CYLINDER:
        question.object.as.cylinder = (sure_cylinder){anchor, end, c->radius};
        break;
    case SURE_SHAPE_CONE: question.object.as.cone = (sure_cone){anchor, end, c->radius}; break;
    }
    return question;
}

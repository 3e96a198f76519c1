/* How the light of photons gets into the eye: joined to a pinhole, or through an opening. */
#ifndef PHOTONS_FORWARD_EYE_H
#define PHOTONS_FORWARD_EYE_H

#include "../tracer/meeting.h"

#include <surehit/forward.h>

#include <stdbool.h>

/* What all photons have in common. */
typedef struct {
    tracing t;
    const sure_forward_options *options;
    sure_forward_splat splat;
    void *film;
    sure_forward_statistics *statistics;
} forward_pass;

/* Where light passes the window, and what one unit of it adds to that pixel. */
typedef struct {
    int column, row;
    double share;
} forward_mark;

/* Is the point, lit on the normal's side, before the pinhole, on the side that the eye is on and
 * within the window's frame? Whether anything is in between is not asked. */
bool forward_faces(const sure_scene *scene, const meeting *at, forward_mark *mark);

/* Draws what so much light adds. */
void forward_draw(const forward_pass *pass, const forward_mark *mark, sure_vec3 light);

/* Does the photon enter the opening before it meets `nearest` (or NULL)? Draws it unless `light` is
 * NULL, and counts `through` and `reached`. */
bool forward_enters(const forward_pass *pass, const sure_ray *ray, const sure_nearest *nearest,
                    const sure_vec3 *light);

#endif

/* SPDX-License-Identifier: MIT */
/* FROZEN with the sources that it is made of (naive.h). */
#include "naive_float.h"

#include <math.h>

#define double float
#define sqrt sqrtf
#define sure_vec3 sure_float_vec3
#define sure_ray sure_ray_f
#define sure_hit sure_hit_f
#define sure_plane sure_plane_f
#define sure_disc sure_disc_f
#define sure_sphere sure_sphere_f
#define sure_cylinder sure_cylinder_f
#define sure_cone sure_cone_f
#define sure_box sure_box_f
#define naive_plane_hit naive_plane_hit_f
#define naive_disc_hit naive_disc_hit_f
#define naive_sphere_hit naive_sphere_hit_f
#define naive_cylinder_hit naive_cylinder_hit_f
#define naive_cone_hit naive_cone_hit_f
#define naive_box_hit naive_box_hit_f

#include "naive_box.c"
#include "naive_cone.c"
#include "naive_cylinder.c"
#include "naive_disc.c"
#include "naive_plane.c"
#include "naive_sphere.c"

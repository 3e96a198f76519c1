/* surehit: ray-surface intersections whose answers can be trusted. Includes every public header. */
#ifndef SUREHIT_SUREHIT_H
#define SUREHIT_SUREHIT_H

#include <surehit/statistics.h>
#include <surehit/answer.h>
#include <surehit/backward.h>
#include <surehit/bounds.h>
#include <surehit/bracket.h>
#include <surehit/bvh.h>
#include <surehit/camera.h>
#include <surehit/cone.h>
#include <surehit/cone_height.h>
#include <surehit/cone_normal.h>
#include <surehit/cone_wall.h>
#include <surehit/cylinder.h>
#include <surehit/cylinder_height.h>
#include <surehit/cylinder_wall.h>
#include <surehit/disc.h>
#include <surehit/forward.h>
#include <surehit/hit_order.h>
#include <surehit/light.h>
#include <surehit/mixed.h>
#include <surehit/object.h>
#include <surehit/phong.h>
#include <surehit/photon_map.h>
#include <surehit/pixel_ray.h>
#include <surehit/plane.h>
#include <surehit/project.h>
#include <surehit/quadratic.h>
#include <surehit/ray.h>
#include <surehit/reflect.h>
#include <surehit/refract.h>
#include <surehit/rotation.h>
#include <surehit/scene.h>
#include <surehit/shadow.h>
#include <surehit/spawn.h>
#include <surehit/sphere.h>
#include <surehit/tier.h>
#include <surehit/vector.h>
#include <surehit/viewport.h>

#endif

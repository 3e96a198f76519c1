/* SPDX-License-Identifier: MIT */
/* surehit: ray-surface intersections whose answers can be trusted. Includes every public header but
 * candidate.h: these, and what they include.
 *
 * Every function may be called by any number of threads at once. None allocates, locks or keeps a
 * pointer that it is handed. A call takes up to 0.6 MB of stack, in rare cases;
 * sure_photon_map_gather always takes 0.4 MB. */
#pragma once

#include <surehit/backward.h>
#include <surehit/bracket.h>
#include <surehit/camera.h>
#include <surehit/cone_height.h>
#include <surehit/cone_normal.h>
#include <surehit/cone_wall.h>
#include <surehit/cylinder_height.h>
#include <surehit/cylinder_wall.h>
#include <surehit/floats.h>
#include <surehit/forward.h>
#include <surehit/hit_order.h>
#include <surehit/mixed.h>
#include <surehit/project.h>
#include <surehit/quadratic.h>
#include <surehit/reflect.h>
#include <surehit/refract.h>
#include <surehit/rotation.h>
#include <surehit/shadow.h>
#include <surehit/version.h>
#include <surehit/viewport.h>

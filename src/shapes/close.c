/* SPDX-License-Identifier: MIT */
/* stages/close.h's rows. An exact product is two operations where one multiplies and adds, else
 * seventeen (numbers/error_free.h). */
#ifdef SURE_FUSED
#define PRODUCTS_APART /* for few processors: short rather than fast */
#endif
#include "../stages/close.h"

#include "box/box_close.h"
#include "box/box_spawn.h"
#include "cone/cone_close.h"
#include "cone/cone_spawn.h"
#include "cylinder/cylinder_close.h"
#include "cylinder/cylinder_spawn.h"
#include "disc/disc_close.h"
#include "plane/plane_close.h"
#include "planar/planar_spawn.h"
#include "sphere/sphere_close.h"
#include "sphere/sphere_spawn.h"

#define CLOSE(shape, SHAPE) {SHAPE##_CLOSE},
#ifdef CLOSE_FUSED
const close_row close_rows_fused[SURE_SHAPES] = {SURE_EACH_SHAPE(CLOSE)};
#else
const close_row close_rows[SURE_SHAPES] = {SURE_EACH_SHAPE(CLOSE)};
#endif

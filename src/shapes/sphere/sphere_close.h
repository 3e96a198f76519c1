/* SPDX-License-Identifier: MIT */
/* The sphere in double-doubles. */
#pragma once

#include "sphere_filter.h"

#define NUMBER dd
#include "sphere_tmpl.h"

#define SPHERE_CLOSE                                                                               \
    .step = sphere_step, .discriminant = sphere_discriminant_of_dd, .spawn = sphere_spawn_quick

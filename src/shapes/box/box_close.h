/* SPDX-License-Identifier: MIT */
/* The box in double-doubles. */
#pragma once

#include "box_filter.h"

#define BOX_CLOSE .step = box_step, .spawn = box_spawn_quick

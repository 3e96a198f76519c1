/* SPDX-License-Identifier: MIT */
/* The disc's rim in exact numbers: the disc's own, and the rim of a solid's cap. */
#pragma once

#include "../../numbers/exact.h"

#define NUMBER exact
#include "planar_tmpl.h"

/* sure_shadow_reaches, counted. */
#ifndef TRACER_SHADOW_H
#define TRACER_SHADOW_H

#include "statistics.h"

#include <stdbool.h>

bool shadow_reaches(const tracing *t, const sure_surface_point *from, sure_vec3 light_position);

#endif

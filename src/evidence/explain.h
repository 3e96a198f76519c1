/* SPDX-License-Identifier: MIT */
/* What of the tracer a scene switches on, and what the rays of its picture came to. */
#pragma once

#include "../tracer/render.h"

#include <stdio.h>

/* Which features lights and materials ask for; the tracer follows further rays only there. */
void explain_features(FILE *out, const sure_scene *scene, const render_options *options);

/* How many rays of each kind, which stage decided their hits, and where they went on from. */
void explain_statistics(FILE *out, const sure_statistics *statistics, sure_tier tier);

/* The sum of so many counts. */
uint64_t explain_sum(const uint64_t *counts, int count);

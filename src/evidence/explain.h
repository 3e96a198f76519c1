/* What of the tracer a scene switches on, and what the rays of its picture came to. */
#ifndef EVIDENCE_EXPLAIN_H
#define EVIDENCE_EXPLAIN_H

#include "../tracer/render.h"

#include <stdio.h>

/* The tracer follows further rays only where lights or materials ask for them. */
typedef struct {
    size_t shapes[SURE_SHAPES]; /* objects of each */
    size_t lights;
    bool shadows;      /* a light, and a surface that shows it */
    size_t highlights; /* objects, where there is light */
    size_t reflecting; /* mirrors, and what has Fresnel's share */
    size_t clear;
    size_t bounded; /* objects that a hierarchy would hold */
    bool hierarchy;
} scene_features;

scene_features scene_features_of(const sure_scene *scene, const render_options *options);

void explain_features(FILE *out, const scene_features *features, const render_options *options);

/* How many rays of each kind, which stage decided their hits, and where they went on from. */
void explain_statistics(FILE *out, const sure_statistics *statistics, sure_tier tier);

#endif

/* Scenes out of a seed: a few dozen objects of every shape with mirrors and lights, seen from among
 * them. */
#ifndef SUPPORT_RANDOM_SCENE_H
#define SUPPORT_RANDOM_SCENE_H

#include <stdint.h>

/* The text; the same for the same seed on every machine. Free it. */
char *random_scene(uint64_t seed);

#endif

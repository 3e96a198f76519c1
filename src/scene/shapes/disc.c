#include "rt_shape.h"

/* No line is a disc. */
const rt_shape rt_disc = {.words = {NULL}};

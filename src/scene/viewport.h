/* The viewport stem for scenes: the tangent correctly rounded, so that pictures do not depend on
 * the C library. */
#ifndef SCENE_VIEWPORT_H
#define SCENE_VIEWPORT_H

/* 2 focal_length tan(pi/360 fov), 0 < fov < 180, focal_length a power of two: correctly
 * rounded unless the tangent is subnormal. */
double viewport_extent(double focal_length, double fov);

#endif

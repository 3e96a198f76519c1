/* A scene file as written: no number is changed but by its correct rounding to double.
 * placement.h turns it into what the tracer sees. */
#ifndef SCENE_RT_H
#define SCENE_RT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include <surehit/surehit.h>

typedef enum { RT_RIGHT_HANDED, RT_LEFT_HANDED } rt_handedness;
typedef enum { RT_FOV_HORIZONTAL, RT_FOV_VERTICAL } rt_fov_axis;
typedef enum { RT_POSITION_MIDDLE, RT_POSITION_BASE, RT_POSITION_APEX } rt_position;

/* What a scene line `#! option value` or the command line may set. */
typedef struct {
    rt_handedness handedness;
    rt_fov_axis fov;
    rt_position cylinder_position; /* middle or base */
    rt_position cone_position;
    sure_falloff falloff;
    bool skip_unknown;
    int width, height;
} rt_options;

/* Which of them the command line has set: those win over the scene's own lines. */
typedef struct {
    bool handedness, fov, cylinder_position, cone_position, falloff, skip_unknown, size;
} rt_options_set;

typedef struct {
    sure_shape shape; /* plane, sphere, cylinder or cone */
    sure_vec3 position;
    sure_vec3 axis;  /* normal of a plane, axis of cylinder and cone; unused for a sphere */
    double diameter; /* unused for a plane */
    double height;   /* cylinder and cone */
    size_t line, column;
} rt_element;

/* Where an element starts in the file. */
typedef struct {
    size_t line, column;
} rt_place;

typedef struct {
    char *name; /* of the file, for messages */
    rt_options options;
    double ambient_ratio;
    sure_vec3 ambient_color; /* 0..1 */
    sure_vec3 camera_position, camera_direction;
    double camera_fov; /* degrees */
    size_t camera_line, camera_column;
    sure_light *lights; /* brightness = ratio, color 0..1, position as written */
    rt_place *light_places; /* one a light */
    size_t light_count;
    rt_element *elements;
    sure_material *materials; /* one an element */
    size_t element_count;
} rt_scene;

#define RT_ERRORS_SHOWN 20

/* The defaults of docs/scene_format.md. */
rt_options rt_default_options(void);

/* Sets one option from its words, as in "handedness" "left". Returns NULL, or what was expected. */
const char *rt_set_option(rt_options *options, rt_options_set *set, const char *name,
                          const char *value);

/* Reads the scene at `path`. `options` holds what the command line has set (named by `set`).
 * Writes FILE:LINE:COLUMN messages to `messages`. Returns true and *scene (free it with
 * rt_scene_free), or false after at least one error, with nothing left allocated. */
bool rt_read(const char *path, const rt_options *options, const rt_options_set *set, FILE *messages,
             rt_scene *scene);

/* The same for text in memory (which may hold NUL bytes); `name` stands for the file. */
bool rt_read_text(const char *text, size_t size, const char *name, const rt_options *options,
                  const rt_options_set *set, FILE *messages, rt_scene *scene);

void rt_scene_free(rt_scene *scene);

#endif

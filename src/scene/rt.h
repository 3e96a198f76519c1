/* SPDX-License-Identifier: MIT */
/* A scene file as written: no number is changed but by its correct rounding to double.
 * placement.h turns it into what the tracer sees. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <jansson.h>
#include <surehit/surehit.h>

typedef enum { RT_RIGHT_HANDED, RT_LEFT_HANDED } rt_handedness;
typedef enum { RT_FOV_HORIZONTAL, RT_FOV_VERTICAL } rt_fov_axis;
typedef enum { RT_POSITION_MIDDLE, RT_POSITION_BASE, RT_POSITION_APEX } rt_position;
typedef enum { RT_STRICT, RT_42 } rt_dialect; /* 42: what is not known is guessed or left out */

/* What a scene line `#! option value` or the command line may set. */
typedef struct {
    rt_handedness handedness;
    rt_fov_axis fov;
    rt_position cylinder_position; /* middle or base */
    rt_position cone_position;
    sure_falloff falloff;
    rt_dialect dialect; /* which has defaults of its own for all the others */
    bool skip_unknown;
    int width, height;
    int camera; /* which of the scene's, from 1 on */
} rt_options;

/* Those with words, in which they are written, and three more. */
typedef enum {
    RT_HANDEDNESS,
    RT_FOV,
    RT_CYLINDER_POSITION,
    RT_CONE_POSITION,
    RT_FALLOFF,
    RT_DIALECT,
    RT_CHOICES, /* so many have words */
    RT_SKIP_UNKNOWN = RT_CHOICES,
    RT_SIZE,
    RT_CAMERA,
    RT_OPTIONS
} rt_option;

/* Some of them, a bit each: those that the command line has set win over the scene's own lines. */
typedef unsigned rt_options_set;

#define RT_SET(option) (1u << (option))
#define RT_SET_ALL (RT_SET(RT_OPTIONS) - 1)

/* In the file, from 1 on; line 0: nowhere. */
typedef struct {
    size_t line, column;
} rt_place;

typedef struct {
    sure_shape shape;
    sure_vec3 position, axis; /* its row (shapes/rt_shape.h) says which of these it has, */
    double diameter, height;  /* and what they are called */
    rt_place at;
} rt_element;

typedef struct {
    sure_light light; /* brightness = ratio, color 0..1, position as written */
    rt_place at;
} rt_light;

typedef struct {
    char *name;    /* of the file, for messages */
    uint64_t hash; /* of its bytes; 0 for text in memory */
    rt_options options;
    double ambient_ratio;
    sure_vec3 ambient_color; /* 0..1 */
    sure_vec3 camera_position, camera_direction;
    double camera_fov; /* degrees */
    rt_place camera_at;
    rt_light *lights;
    size_t light_count;
    rt_element *elements;
    sure_material *materials; /* one an element */
    size_t element_count;
} rt_scene;

#define RT_ERRORS_SHOWN 20

/* The defaults of docs/scene_format.md: of each enumeration the first. */
#define RT_DEFAULTS                                                                                \
    {                                                                                              \
        .width = 1280, .height = 720, .camera = 1                                                  \
    }
rt_options rt_default_options(void);

/* What holds in a dialect where nothing else is said. */
rt_options rt_dialect_options(rt_dialect dialect);

/* An option's name, and its word of those with words. */
const char *rt_option_name(rt_option option);
const char *rt_option_word(const rt_options *options, rt_option choice);

/* Takes over those of the set. */
void rt_take_options(rt_options *to, const rt_options *from, rt_options_set which);

/* The name of one in which they differ; NULL where they are the same. */
const char *rt_options_difference(const rt_options *a, const rt_options *b);

/* As JSON. Read back, what is wrong is returned, or NULL. */
json_t *rt_options_json(const rt_options *options);
const char *rt_options_from_json(const json_t *object, rt_options *options);

/* Sets one option from its words, as in "handedness" "left". Returns NULL, or what was expected. */
const char *rt_set_option(rt_options *options, rt_options_set *set, const char *name,
                          const char *value);

/* Reads the scene at `path`, or "-", standard input. `options` holds what the command line has set
 * (named by `set`). Writes FILE:LINE:COLUMN messages to `messages`. Returns true and *scene (free
 * it with rt_scene_free), or false after at least one error, with nothing left allocated. */
bool rt_read(const char *path, const rt_options *options, rt_options_set set, FILE *messages,
             rt_scene *scene);

/* The same in two steps, for those who want to know first whose bytes they are. */
typedef struct {
    const char *path;
    char *text; /* to be freed by free(), whatever was returned */
    size_t size;
    uint64_t hash; /* FNV-1a, 64 bits (fnv.h): it tells scenes that were mistaken for one another,
                    * not those that were made alike */
} rt_bytes;

bool rt_load(const char *path, FILE *messages, rt_bytes *bytes);
bool rt_read_loaded(const rt_bytes *bytes, const rt_options *options, rt_options_set set,
                    FILE *messages, rt_scene *scene);

/* The same for text in memory (which may hold NUL bytes); `name` stands for the file. */
bool rt_read_text(const char *text, size_t size, const char *name, const rt_options *options,
                  rt_options_set set, FILE *messages, rt_scene *scene);

void rt_scene_free(rt_scene *scene);

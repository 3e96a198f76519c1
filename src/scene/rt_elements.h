/* The lines of a scene that are parts of it: light, camera, shapes. */
#ifndef SCENE_RT_ELEMENTS_H
#define SCENE_RT_ELEMENTS_H

#include "rt_fields.h"

typedef struct {
    rt_notes notes;
    rt_line line;
    const rt_options *options; /* of the command line */
    rt_options_set set;
    bool out_of_memory;

    rt_scene scene;
    rt_options_set set_by_scene;
    size_t ambient_line; /* 0: none seen */
    bool has_light;
} rt_reader;

/* Each reads the fields behind its line's first word. */
void rt_read_ambient(rt_reader *r, rt_word identifier);
void rt_read_camera(rt_reader *r, rt_word identifier);
void rt_read_light(rt_reader *r, rt_word identifier);
void rt_read_shape(rt_reader *r, rt_word identifier, sure_shape shape);

#endif

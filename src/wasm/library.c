/* SPDX-License-Identifier: MIT */
/* The library for scripts: they write rays and objects into the room, call, and read. */
#include "export.h"
#include "room.h"

#include <surehit/many.h>

#include <string.h>

/* So many are asked at once. */
#define ROOM 1024

static struct {
    double rays[ROOM][8], objects[ROOM][SURE_SHAPE_NUMBERS];
    double t[ROOM], t_error[ROOM], normal[ROOM][3];
    uint8_t status[ROOM], part[ROOM], leaves[ROOM];
} room;
_Static_assert(sizeof(sure_ray) == sizeof room.rays[0], "a ray is its numbers");

int WASM_EXPORT(room_size)(void)
{
    return ROOM;
}

#define ROOM_COLUMN(name)                                                                          \
    void *WASM_EXPORT(room_##name)(void)                                                           \
    {                                                                                              \
        return room.name;                                                                          \
    }
ROOM_COLUMN(rays)
ROOM_COLUMN(objects)
ROOM_COLUMN(t)
ROOM_COLUMN(t_error)
ROOM_COLUMN(normal)
ROOM_COLUMN(status)
ROOM_COLUMN(part)
ROOM_COLUMN(leaves)

/* So many rays of the room, each of its own object (`several`), or all of the first one. */
void WASM_EXPORT(hits)(int count, sure_shape shape, sure_tier tier, int several, int with_normals)
{
    const ptrdiff_t object = (ptrdiff_t)sizeof(double) * sure_shape_info_of(shape)->numbers;
    const sure_rays rays = sure_rays_of(room.rays, sizeof room.rays[0]);
    const sure_objects objects = sure_objects_of(shape, room.objects, several ? object : 0);
    const ptrdiff_t number = sizeof(double), vector = sizeof room.normal[0];
    sure_hits to = {.status = {room.status, 1},
                    .part = {room.part, 1},
                    .leaves = {room.leaves, 1},
                    .t = {room.t, number},
                    .t_error = {room.t_error, number}};
    for (int i = 0; i < 3 && with_normals; i++)
        to.normal[i] = (sure_number_column){&room.normal[0][i], vector};
    sure_objects_hits((size_t)count, &rays, &objects, tier, &to);
}

sure_ray room_ray(int i)
{
    sure_ray ray;
    memcpy(&ray, room.rays[i], sizeof ray);
    return ray;
}

/* Objects stand one behind the other. */
static double *place_of(int i, sure_shape shape)
{
    return room.objects[0] + i * sure_shape_info_of(shape)->numbers;
}

sure_object room_object(int i, sure_shape shape)
{
    sure_object object = {.shape = shape};
    memcpy(&object.as, place_of(i, shape),
           sizeof(double) * (size_t)sure_shape_info_of(shape)->numbers);
    return object;
}

void room_put(int i, const sure_ray *ray, const sure_object *object)
{
    memcpy(room.rays[i], ray, sizeof *ray);
    memcpy(place_of(i, object->shape), &object->as,
           sizeof(double) * (size_t)sure_shape_info_of(object->shape)->numbers);
}

/* Of the room's first ray and object. */

sure_field WASM_EXPORT(check)(sure_shape shape)
{
    const sure_ray ray = room_ray(0);
    const sure_object object = room_object(0, shape);
    return sure_object_check(&ray, &object);
}

sure_status WASM_EXPORT(occluded)(sure_shape shape, sure_tier tier)
{
    const sure_ray ray = room_ray(0);
    const sure_object object = room_object(0, shape);
    return sure_object_occluded(&ray, &object, tier);
}

/* Its ends are the room's first two t and parts. */
sure_status WASM_EXPORT(interval)(sure_shape shape, sure_tier tier)
{
    const sure_ray ray = room_ray(0);
    const sure_object object = room_object(0, shape);
    sure_interval ends;
    sure_status status = sure_object_interval(&ray, &object, tier, &ends);
    if (status != SURE_HIT)
        return status;
    room.t[0] = ends.t_enter;
    room.t[1] = ends.t_leave;
    room.part[0] = (uint8_t)ends.enter_part;
    room.part[1] = (uint8_t)ends.leave_part;
    return status;
}

sure_stage WASM_EXPORT(stage)(sure_shape shape, sure_tier tier)
{
    const sure_ray ray = room_ray(0);
    const sure_object object = room_object(0, shape);
    return sure_object_stage(&ray, &object, tier);
}

/* Words, by number; NULL ends them. */
#define WORDS(of)                                                                                  \
    const char *WASM_EXPORT(of##_name)(sure_##of which)                                            \
    {                                                                                              \
        return sure_##of##_name(which);                                                            \
    }
WORDS(shape)
WORDS(tier)
WORDS(status)
WORDS(part)
WORDS(field)
WORDS(stage)

int WASM_EXPORT(shape_numbers)(sure_shape shape)
{
    return sure_shape_info_of(shape)->numbers;
}

/* The shape's fields: which they are and where their numbers begin; -1 ends them. */
int WASM_EXPORT(shape_field)(sure_shape shape, int i)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    return i < info->field_count ? (int)info->fields[i].name : -1;
}

int WASM_EXPORT(shape_field_at)(sure_shape shape, int i)
{
    return sure_shape_info_of(shape)->fields[i].at;
}

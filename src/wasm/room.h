/* SPDX-License-Identifier: MIT */
/* Where scripts and the library exchange rays and objects (library.c). */
#pragma once

#include <surehit/object.h>

/* Number i of the room, of that shape; and back. Entry: i is below room_size(). */
int room_size(void);
void room_put(int i, const sure_ray *ray, const sure_object *object);
sure_ray room_ray(int i);
sure_object room_object(int i, sure_shape shape);

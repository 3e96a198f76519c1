/* SPDX-License-Identifier: MIT */
#include "reflect.h"

#include <surehit/reflect.h>

#include <assert.h>

sure_vec3 TIER(sure_reflect)(sure_vec3 v, sure_vec3 n)
{
    assert(project_entry_ok(v, n));
    return vec3_public(reflect(vec3_from(v), vec3_from(n)));
}

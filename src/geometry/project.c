/* SPDX-License-Identifier: MIT */
#include "project.h"

#include <surehit/project.h>

#include <assert.h>

sure_vec3 TIER(sure_project)(sure_vec3 v, sure_vec3 n)
{
    assert(project_entry_ok(v, n));
    return vec3_public(project(vec3_from(v), vec3_from(n)));
}

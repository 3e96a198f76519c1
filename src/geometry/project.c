#include "project.h"

#include <surehit/project.h>

sure_vec3 TIER(sure_project)(sure_vec3 v, sure_vec3 n)
{
    return vec3_public(project(vec3_from(v), vec3_from(n)));
}

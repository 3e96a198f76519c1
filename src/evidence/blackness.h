/* SPDX-License-Identifier: MIT */
/* Why a picture is black. */
#pragma once

#include <surehit/statistics.h>

#include <stdio.h>

/* A warning to `messages`, of the scene that `name` stands for: that no ray met anything, and where
 * the objects are; or why what was met is black. The statistics are of all rays of the picture. */
void blackness_explain(FILE *messages, const char *name, const sure_scene *scene,
                       const sure_statistics *statistics);

/* SPDX-License-Identifier: MIT */
/* What a picture's pixels see, as text that can be checked: docs/tracer.md has the format. */
#pragma once

#include "../tracer/render.h"
#include "../scene/rt.h"

/* What it says of a pixel. */
typedef struct {
    sure_vec3 direction; /* of the ray, which starts at the eye */
    pixel_record pixel;  /* without its time */
} pixel_claim;

/* The words of its line, and back; a scene has so many objects. False: they are no claim. */
#define CLAIM_WORDS 256 /* more than it can have */
void claim_print(const pixel_claim *one, char words[CLAIM_WORDS]);
bool claim_read(const char *line, size_t objects, pixel_claim *read);

typedef struct {
    uint64_t hash;   /* of its bytes */
    json_t *numbers; /* of its objects, as certificate_numbers tells them */
    sure_vec3 eye;
    rt_options options; /* as resolved; the size is the whole picture's */
    picture_part part;  /* width and height are set */
    sure_tier tier;     /* certain or exact */
    sure_statistics statistics;
    pixel_claim *claims; /* of the part, in reading order */
} certificate;

/* A line of text an object, its shape and its fields; NULL when there is no memory. */
json_t *certificate_numbers(const sure_scene *scene);

/* The ray of the part's i-th pixel. What the eye touches is not in front of it: t starts at the
 * least number above 0. */
sure_ray certificate_ray(const sure_scene *scene, const picture_part *part, size_t i);

/* Writes one of the scene called `name`, whose records are the part's; hash, options, part, tier
 * and statistics are told by `of`. The file appears whole or not at all. On false, here and below,
 * one line was written to standard error. */
bool certificate_write(const certificate *of, const char *name, const sure_scene *scene,
                       const pixel_record *records, const char *path);

/* Reads one (free it with certificate_free). The line says which line is wrong; nothing is left
 * allocated then. */
bool certificate_read(const char *path, certificate *read);

void certificate_free(certificate *of);

typedef struct {
    int threads;   /* 0: one a core */
    bool quick;    /* with the hierarchy, which a check is otherwise independent of */
    bool progress; /* a bar on standard error */
    bool quiet;    /* no line when all is right */
} check_options;

/* Is what the certificate at `path` says of the scene's picture true? Asks `exact` about every
 * pixel. The first few that are wrong are printed, both answers in a line, then "57600 pixels, all
 * right", or how many are wrong and how. Returns 0 where all is right, else 1; 2 after a line to
 * standard error: one of both can't be read, or it is another scene. */
int certificate_check(const char *path, const char *scene, const check_options *options);

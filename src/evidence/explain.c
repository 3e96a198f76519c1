/* SPDX-License-Identifier: MIT */
#include "explain.h"

#include "../hierarchy/bvh_build.h"
#include "../tracer/visible.h"

#include <inttypes.h>
#include <string.h>

typedef struct {
    size_t shapes[SURE_SHAPES]; /* objects of each */
    size_t lights;
    bool shadows;      /* a light, and a surface that shows it */
    size_t highlights; /* objects, where there is light */
    size_t reflecting; /* mirrors, and what has Fresnel's share */
    size_t clear;
} features;

static features features_of(const sure_scene *scene)
{
    features has = {.lights = scene->light_count};
    for (size_t i = 0; i < scene->object_count; i++) {
        const sure_material *material = &scene->materials[i];
        bool clear = material->refract > 0, shiny = material->specular > 0;
        bool reflects = material->mirror > 0 || material->refract > 1;
        has.shapes[scene->objects[i].shape]++;
        has.reflecting += reflects;
        has.clear += clear;
        has.highlights += shiny && has.lights > 0;
        has.shadows = has.shadows || (has.lights > 0 && (shiny || !clear));
    }
    return has;
}

static const char *plural(size_t count)
{
    return count == 1 ? "" : "s";
}

/* Boxes, not boxs. */
static const char *plural_of(const char *name, size_t count)
{
    return count != 1 && name[strlen(name) - 1] == 'x' ? "es" : plural(count);
}

static void print_objects(FILE *out, const features *has)
{
    const char *between = "objects      ";
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (has->shapes[shape] == 0)
            continue;
        const char *name = sure_shape_name((sure_shape)shape);
        fprintf(out, "%s %zu %s%s", between, has->shapes[shape], name,
                plural_of(name, has->shapes[shape]));
        between = ",";
    }
    fputs(between[0] == ',' ? "\n" : "objects       none\n", out);
}

static void print_feature(FILE *out, const char *name, bool on)
{
    fprintf(out, "%-13s %s", name, on ? "on" : "off");
}

static void print_counted(FILE *out, const char *name, size_t count, const char *what)
{
    print_feature(out, name, count > 0);
    if (count > 0)
        fprintf(out, ": %zu %s%s", count, what, plural(count));
    fputc('\n', out);
}

/* Objects that are there, and followed where rays go on at all. */
static void print_followed(FILE *out, const char *name, size_t count, int depth)
{
    if (count > 0 && depth < 1)
        fprintf(out, "%-13s off: --depth 0\n", name);
    else
        print_counted(out, name, count, "object");
}

static void print_hierarchy(FILE *out, const sure_scene *scene, bool refused)
{
    size_t bounded = bvh_bounded(scene->objects, scene->object_count);
    bool built = !refused && bounded >= BVH_WORTHWHILE;
    print_feature(out, "hierarchy", built);
    if (built)
        fprintf(out, ": %zu objects\n", bounded);
    else if (refused)
        fputs(": --no-hierarchy\n", out);
    else
        fprintf(out, ": %zu bounded object%s, worth it from %d on\n", bounded, plural(bounded),
                BVH_WORTHWHILE);
}

void explain_features(FILE *out, const sure_scene *scene, const render_options *options)
{
    const features has = features_of(scene);
    print_objects(out, &has);
    print_counted(out, "lights", has.lights, "light");
    print_feature(out, "shadows", has.shadows);
    fputc('\n', out);
    print_counted(out, "highlights", has.highlights, "object");
    print_followed(out, "reflection", has.reflecting, scene->depth);
    print_followed(out, "refraction", has.clear, scene->depth);
    print_hierarchy(out, scene, options->without_bvh);
}

uint64_t explain_sum(const uint64_t *counts, int count)
{
    uint64_t sum = 0;
    for (int i = 0; i < count; i++)
        sum += counts[i];
    return sum;
}

/* A line of a table; with a share where there is anything to share. */
static void print_row(FILE *out, const char *name, uint64_t count, uint64_t of)
{
    fprintf(out, "  %-16s %12" PRIu64, name, count);
    if (of > 0)
        fprintf(out, " %9.4f %%", 100 * (double)count / (double)of);
    fputc('\n', out);
}

static void print_stages(FILE *out, const sure_statistics *statistics)
{
    const uint64_t hits = explain_sum(statistics->decided, SURE_STAGES);
    fprintf(out, "hits decided by the stage%12" PRIu64 "\n", hits);
    for (int stage = 0; stage < SURE_STAGES; stage++)
        print_row(out, sure_stage_name((sure_stage)stage), statistics->decided[stage], hits);
}

static void print_origins(FILE *out, const sure_statistics *statistics)
{
    fprintf(out, "starts of further rays%15" PRIu64 "\n", statistics->origins);
    print_row(out, "covered", statistics->covered, 0);
    print_row(out, "not found", statistics->without_origin, 0);
    print_row(out, "acne", statistics->acne, 0);
}

void explain_statistics(FILE *out, const sure_statistics *statistics, sure_tier tier)
{
    const uint64_t all = explain_sum(statistics->rays, SURE_RAY_KINDS);
    fprintf(out, "rays %32" PRIu64 "\n", all);
    for (int kind = 0; kind < SURE_RAY_KINDS; kind++)
        print_row(out, sure_ray_kind_name((sure_ray_kind)kind), statistics->rays[kind], all);
    print_row(out, "met nothing", statistics->missed, all);
    if (is_sure(tier)) {
        print_stages(out, statistics);
        print_origins(out, statistics);
    } else {
        fprintf(out, "tier %s has no stages and promises nothing; acne %17" PRIu64 "\n",
                sure_tier_name(tier), statistics->acne);
    }
}

/* SPDX-License-Identifier: MIT */
#include "plugin_functions.h"

#include <surehit/candidate.h>

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

/* The tiers as a library could have them: alone, or with the normal of a hit. */

/* The numbers of a case are ray and object as they lie in memory. */
_Static_assert(offsetof(sure_ray, t_max) == 7 * sizeof(double), "a ray's");

/* `in`: nothing, or _float; `f`: how the library has it. */
#define HITS_IN(shape, tier, in, f)                                                                \
    static int shape##_##tier##in(const void *ray, const void *object, void *to)                   \
    {                                                                                              \
        tier_output##in *of = to;                                                                  \
        return (int)sure_##shape##_hit_##tier##f(ray, object, &of->hit);                           \
    }                                                                                              \
    static int shape##_##tier##_normal##in(const void *ray, const void *object, void *to)          \
    {                                                                                              \
        tier_output##in *of = to;                                                                  \
        int status = shape##_##tier##in(ray, object, to);                                          \
        if (status == SURE_HIT)                                                                    \
            of->normal = sure_##shape##_normal_##tier##f(ray, object, &of->hit);                   \
        return status;                                                                             \
    }

#define FUNCTIONS(shape, tier)                                                                     \
    HITS_IN(shape, tier, , )                                                                       \
    static int shape##_##tier##_occluded(const void *ray, const void *object)                      \
    {                                                                                              \
        return (int)sure_##shape##_occluded_##tier(ray, object);                                   \
    }                                                                                              \
    static int shape##_##tier##_interval(const void *ray, const void *object, void *to)            \
    {                                                                                              \
        return (int)sure_##shape##_interval_##tier(ray, object, to);                               \
    }                                                                                              \
    static int shape##_##tier##_inside(const void *ray, const void *object)                        \
    {                                                                                              \
        sure_interval chord;                                                                       \
        return (int)sure_##shape##_interval_##tier(ray, object, &chord);                           \
    }

#define TIERS(X, shape)                                                                            \
    X(shape, float32) X(shape, textbook) X(shape, stable) X(shape, certain) X(shape, exact)

_Static_assert(offsetof(sure_ray_f, t_max) == 7 * sizeof(float), "likewise");

#define ALL_FUNCTIONS(shape, SHAPE)                                                                \
    TIERS(FUNCTIONS, shape)                                                                        \
    HITS_IN(shape, certain, _float, _f)                                                            \
    HITS_IN(shape, exact, _float, _f)
SURE_EACH_SHAPE(ALL_FUNCTIONS)

typedef struct {
    one_routine *hit, *with_normal, *interval;
    decision_routine *occluded, *inside;
} tier_functions;

#define ROW(shape, tier)                                                                           \
    {shape##_##tier, shape##_##tier##_normal, shape##_##tier##_interval,                           \
     shape##_##tier##_occluded, shape##_##tier##_inside},
#define ALL_TIERS(shape, SHAPE) {TIERS(ROW, shape)},
static const tier_functions tiers[SURE_SHAPES][SURE_TIERS] = {SURE_EACH_SHAPE(ALL_TIERS)};

/* certain's and exact's hits in floats: alone, with normals. */
#define FLOAT_ROW(shape, SHAPE)                                                                    \
    {{shape##_certain_float, shape##_certain_normal_float},                                        \
     {shape##_exact_float, shape##_exact_normal_float}},
static one_routine *const float_tiers[SURE_SHAPES][2][2] = {SURE_EACH_SHAPE(FLOAT_ROW)};

/* dlsym's void * is a function's address, which ISO C can only be told byte by byte. */
static bool find(void *library, const char *shape, const char *suffix, int in, void *function)
{
    char name[64];
    snprintf(name, sizeof name, "sure_candidate_%s%s%s", shape, suffix,
             in == PRECISION_FLOAT ? "_float" : "");
    void *address = dlsym(library, name);
    memcpy(function, &address, sizeof address);
    return address;
}

/* For prepared objects, where there are such. */
static bool find_query(void *library, const char *shape, query asks, int in, functions *all)
{
    static const char *const suffixes[QUERIES] = {"", "_occluded", "_interval", "_inside"};
    bool decides = asks == QUERY_OCCLUDED || asks == QUERY_INSIDE;
    void *function = decides ? (void *)&all->decide : &all->one;
    char suffix[32];
    snprintf(suffix, sizeof suffix, "%s_prepared", suffixes[asks]);
    if (all->build && find(library, shape, suffix, in, function))
        return true;
    all->build = NULL;
    bool one = find(library, shape, suffixes[asks], in, function);
    return (asks == QUERY_HIT && find(library, shape, "_many", in, &all->many)) || one;
}

/* False after a message: functions that go together aren't all there. */
static bool find_shape(const char *path, void *library, int shape, int in, function_table of,
                       plugin_answers *to)
{
    const char *name = sure_shape_name((sure_shape)shape);
    functions building = {0};
    bool builds = find(library, name, "_new", in, &building.build), prepared = false;
    bool frees = find(library, name, "_free", PRECISION_DOUBLE, &building.free);
    for (int asks = 0; asks < QUERIES; asks++) {
        functions *all = &of[asks][shape][in];
        *all = building;
        to->has[asks][shape][in] = find_query(library, name, (query)asks, in, all);
        prepared |= all->build != NULL;
    }
    return !builds || (frees && prepared) ||
           complain(to->message, "%s: sure_candidate_%s_new without _prepared or _free", path,
                    name);
}

static bool find_functions(const char *path, void *library, function_table of, plugin_answers *to)
{
    bool any = false;
    for (int i = 0; i < SURE_SHAPES * 2; i++) {
        if (!find_shape(path, library, i / 2, i % 2, of, to))
            return false;
        for (int asks = 0; asks < QUERIES; asks++)
            any |= to->has[asks][i / 2][i % 2];
    }
    return any || complain(to->message, "%s: no symbol sure_candidate_<shape>", path);
}

static void take_words(void *library, const char *symbol, char *to, size_t room)
{
    const char *words = dlsym(library, symbol);
    snprintf(to, room, "%s", words ? words : "");
}

static bool load(const char *path, function_table of, plugin_answers *to)
{
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return complain(to->message, "%s", dlerror());
    const int *version = dlsym(library, "sure_candidate_version");
    if (!version)
        return complain(to->message, "%s: no symbol sure_candidate_version", path);
    if (*version != SURE_CANDIDATE_VERSION)
        return complain(to->message, "%s: sure_candidate_version is %d, expected %d", path,
                        *version, SURE_CANDIDATE_VERSION);
    take_words(library, "sure_candidate_entry", to->entry, sizeof to->entry);
    take_words(library, "sure_candidate_name", to->who.name, sizeof to->who.name);
    take_words(library, "sure_candidate_release", to->who.version, sizeof to->who.version);
    take_words(library, "sure_candidate_build", to->who.build, sizeof to->who.build);
    return find_functions(path, library, of, to);
}

bool functions_find(const plugin_source *from, function_table of, plugin_answers *to)
{
    if (from->path)
        return load(from->path, of, to);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        const tier_functions *have = &tiers[shape][from->tier];
        of[QUERY_HIT][shape][0].one = from->with_normals ? have->with_normal : have->hit;
        of[QUERY_OCCLUDED][shape][0].decide = have->occluded;
        of[QUERY_INTERVAL][shape][0].one = have->interval;
        of[QUERY_INSIDE][shape][0].decide = have->inside;
        if (tier_takes_floats(from->tier, QUERY_HIT))
            of[QUERY_HIT][shape][PRECISION_FLOAT].one =
                float_tiers[shape][from->tier - SURE_TIER_CERTAIN][from->with_normals];
    }
    memset(to->has, true, sizeof to->has); /* of others it is the functions for doubles */
    return true;
}

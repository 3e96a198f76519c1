#include "plugin_functions.h"

#include <surehit/candidate.h>

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

/* The tiers as a library could have them: alone, or with the normal of a hit. */

/* The numbers of a case are ray and object as they lie in memory. */
_Static_assert(offsetof(sure_ray, t_max) == 7 * sizeof(double), "a ray's");

#define FUNCTIONS(shape, tier)                                                                     \
    static int shape##_##tier(const void *ray, const void *object, void *to)                       \
    {                                                                                              \
        return (int)sure_##shape##_hit_##tier(ray, object, &((tier_output *)to)->hit);             \
    }                                                                                              \
    static int shape##_##tier##_normal(const void *ray, const void *object, void *to)              \
    {                                                                                              \
        tier_output *of = to;                                                                      \
        int status = shape##_##tier(ray, object, to);                                              \
        if (status == SURE_HIT)                                                                    \
            of->normal = sure_##shape##_normal_##tier(ray, object, &of->hit);                      \
        return status;                                                                             \
    }

#define TIERS(X, shape)                                                                            \
    X(shape, float32) X(shape, textbook) X(shape, stable) X(shape, certain) X(shape, exact)

#define ALL_FUNCTIONS(shape, SHAPE) TIERS(FUNCTIONS, shape)
SURE_EACH_SHAPE(ALL_FUNCTIONS)

#define BOTH(shape, tier) {shape##_##tier, shape##_##tier##_normal},
#define ALL_TIERS(shape, SHAPE) {TIERS(BOTH, shape)},
static one_routine *const tiers[SURE_SHAPES][SURE_TIERS][2] = {SURE_EACH_SHAPE(ALL_TIERS)};

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

static bool find_functions(const char *path, void *library, functions of[SURE_SHAPES][2],
                           plugin_answers *to)
{
    bool any = false;
    for (int i = 0; i < SURE_SHAPES * 2; i++) {
        const char *shape = sure_shape_name((sure_shape)(i / 2));
        functions *all = &of[i / 2][i % 2];
        bool builds = find(library, shape, "_new", i % 2, &all->build);
        bool one = find(library, shape, builds ? "_prepared" : "", i % 2, &all->one);
        bool many = !builds && find(library, shape, "_many", i % 2, &all->many);
        if (builds && !(find(library, shape, "_free", PRECISION_DOUBLE, &all->free) && one))
            return complain(to->message, "%s: sure_candidate_%s_new without _prepared or _free",
                            path, shape);
        any |= to->has[i / 2][i % 2] = one || many;
    }
    return any || complain(to->message, "%s: no symbol sure_candidate_<shape>", path);
}

static void take_words(void *library, const char *symbol, char *to, size_t room)
{
    const char *words = dlsym(library, symbol);
    snprintf(to, room, "%s", words ? words : "");
}

static bool load(const char *path, functions of[SURE_SHAPES][2], plugin_answers *to)
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

bool functions_find(const plugin_source *from, functions of[SURE_SHAPES][2], plugin_answers *to)
{
    if (from->path)
        return load(from->path, of, to);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        of[shape][PRECISION_DOUBLE].one = tiers[shape][from->tier][from->with_normals];
        to->has[shape][PRECISION_DOUBLE] = true;
        to->has[shape][PRECISION_FLOAT] = true; /* in doubles, too */
    }
    return true;
}

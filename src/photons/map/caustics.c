/* SPDX-License-Identifier: MIT */
/* Photons leave each light through those cells of a cube about it in which something shiny may be
 * met, the same number through each cell. */
#include "caustics.h"

#include "../../support/openmp.h"
#include "../photon.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How many photons: docs/derivations/mixed.md. The first ones tell how many land; a picture of up
 * to FEW_PIXELS has no others. */
#define FIRST 800
#define FEW_PIXELS 3600
/* Most that are to land, and of all that leave the least share. */
#define LANDED_MOST 2000000
#define SHARE_LEAST 0.25

/* Cells along a face's half, at most. */
#define CELLS_MOST 32
#define FACES 24 /* by axis and octant */

/* A light's cells: of each face the rows. */
typedef struct {
    bool active[FACES][CELLS_MOST][CELLS_MOST];
} cube;

/* Photons of a cell. */
typedef struct {
    sure_mixed_cell cell;
    uint32_t strata;
    size_t count; /* that landed */
    sure_photon *landed;
} batch;

typedef struct {
    const sure_scene *scene;
    const render_settings *settings;
    uint64_t photons; /* that are to leave */
    double power;     /* of all lights */
    int cells;
    batch *batches;
    size_t batch_count;
} emission;

/* How many cells this makes active. */
static size_t mark_face(const emission *e, const sure_object *object, sure_vec3 light, int face,
                        cube *of)
{
    const int axis = face / 8, octant = face % 8;
    size_t count = 0;
    sure_mixed_strip column = sure_mixed_strip_of(object, light, axis, octant, 1, e->cells);
    if (column.first > column.last)
        return 0;
    sure_mixed_strip row = sure_mixed_strip_of(object, light, axis, octant, 2, e->cells);
    for (int j = row.first; j <= row.last; j++) {
        for (int i = column.first; i <= column.last; i++) {
            count += !of->active[face][j][i];
            of->active[face][j][i] = true;
        }
    }
    return count;
}

/* How many cells of the light are active: none of one that has nothing to give. */
static size_t mark(const emission *e, const sure_light *light, cube *of)
{
    const sure_scene *scene = e->scene;
    const size_t all = (size_t)FACES * (size_t)(e->cells * e->cells);
    size_t count = 0;
    memset(of, 0, sizeof *of);
    for (size_t i = 0; i < scene->object_count && count < all && power_of(light) > 0; i++) {
        for (int face = 0; face < FACES && sure_mixed_is_shiny(&scene->materials[i]); face++)
            count += mark_face(e, &scene->objects[i], light->position, face, of);
    }
    return count;
}

/* A square of them is what a cell gets of the light's share. */
static uint32_t strata_of(const emission *e, const sure_light *light, size_t active)
{
    double share = (double)e->photons * (power_of(light) / e->power) / (double)active;
    double strata = floor(sqrt(share) + 0.5);
    return strata >= 1 ? (uint32_t)fmin(strata, 0xffff) : 1;
}

static void add_batches(emission *e, size_t light, const cube *of, size_t active)
{
    uint32_t strata = active > 0 ? strata_of(e, &e->scene->lights[light], active) : 0;
    for (int face = 0; face < FACES && active > 0; face++) {
        for (int j = 0; j < e->cells; j++) {
            for (int i = 0; i < e->cells; i++) {
                sure_mixed_cell cell = {light, face / 8, face % 8, i, j, e->cells};
                if (of->active[face][j][i])
                    e->batches[e->batch_count++] = (batch){.cell = cell, .strata = strata};
            }
        }
    }
}

/* How many cells are active, or some number above that of the photons. */
static uint64_t active_cells(const emission *e, cube *of)
{
    uint64_t count = 0;
    for (size_t i = 0; i < e->scene->light_count && count <= e->photons; i++)
        count += mark(e, &e->scene->lights[i], of);
    return count;
}

/* All lights' in their order, each of which may meet many objects. */
static bool make_batches(emission *e)
{
    const size_t lights = e->scene->light_count;
    const int threads = lights > 1 ? openmp_threads(e->settings->how.threads) : 1;
    bool made = true;
    (void)threads; /* where there is no OpenMP */
    OPENMP(omp parallel for ordered schedule(dynamic) num_threads(threads))
    for (size_t i = 0; i < lights; i++) {
        cube *of = malloc(sizeof *of);
        size_t active = of ? mark(e, &e->scene->lights[i], of) : 0;
        OPENMP(omp ordered)
        {
            made = made && of;
            if (of)
                add_batches(e, i, of, active);
        }
        free(of);
    }
    return made;
}

/* Cells as small as there are photons for each; those of half a face, at least. */
static bool plan(emission *e)
{
    cube *of = malloc(sizeof *of);
    uint64_t count = FACES * (uint64_t)e->scene->light_count, found = UINT64_MAX;
    e->cells = CELLS_MOST;
    while (of && e->cells > 1 && (found = active_cells(e, of)) > e->photons)
        e->cells /= 2;
    if (e->cells > 1)
        count = found;
    e->batches = of ? malloc((count + 1) * sizeof *e->batches) : NULL;
    free(of);
    return e->batches && make_batches(e);
}

/* What can't be told from nothing or from everything is left out. */
static bool has_weight(const sure_photon *of)
{
    double sum = of->weight.x + of->weight.y + of->weight.z;
    return sum > 0 && sum < INFINITY && of->length < INFINITY;
}

static size_t photons_of(const batch *of)
{
    return (size_t)of->strata * of->strata;
}

/* `landed` stays NULL when there is no memory. */
static void trace_batch(const emission *e, batch *of)
{
    sure_photon *landed = malloc(photons_of(of) * sizeof *landed), one;
    for (size_t i = 0; landed && i < photons_of(of); i++) {
        if (sure_mixed_photon(e->scene, e->settings->how.tier, &of->cell, of->strata, (uint32_t)i,
                              e->settings->seed, &one) &&
            has_weight(&one))
            landed[of->count++] = one;
    }
    sure_photon *fitting = landed ? realloc(landed, (of->count + 1) * sizeof *landed) : NULL;
    of->landed = fitting ? fitting : landed;
}

/* What lands, batch by batch; NULL when there is no memory. */
static sure_photon *trace(emission *e, caustics_statistics *statistics)
{
    const int threads = e->photons > FIRST ? openmp_threads(e->settings->how.threads) : 1;
    (void)threads; /* where there is no OpenMP */
    OPENMP(omp parallel for schedule(dynamic) num_threads(threads))
    for (size_t i = 0; i < e->batch_count; i++)
        trace_batch(e, &e->batches[i]);
    for (size_t i = 0; i < e->batch_count; i++) {
        statistics->traced += photons_of(&e->batches[i]);
        statistics->landed += e->batches[i].count;
    }
    sure_photon *all = malloc((statistics->landed + 1) * sizeof *all), *to = all;
    for (size_t i = 0; all && i < e->batch_count; i++) {
        if (!e->batches[i].landed) {
            free(all);
            return NULL;
        }
        memcpy(to, e->batches[i].landed, e->batches[i].count * sizeof *to);
        to += e->batches[i].count;
    }
    return all;
}

static caustics_state need(const sure_scene *scene, integrator_kind integrator)
{
    bool shiny = false, matte = false, lit = total_power(scene) > 0;
    if (integrator != INTEGRATOR_AUTO && integrator != INTEGRATOR_MIXED)
        return CAUSTICS_NOT_ASKED;
    for (size_t i = 0; i < scene->object_count && !(shiny && matte); i++) {
        shiny = shiny || sure_mixed_is_shiny(&scene->materials[i]);
        matte = matte || sure_mixed_is_matte(&scene->materials[i]);
    }
    if (!shiny || scene->depth < 1)
        return shiny ? CAUSTICS_NOT_FOLLOWED : CAUSTICS_NOT_SHINY;
    if (!lit || !matte)
        return !lit ? CAUSTICS_NOT_LIT : CAUSTICS_NOT_MATTE;
    return scene->falloff == SURE_FALLOFF_NONE && integrator == INTEGRATOR_AUTO ? CAUSTICS_ENDLESS
                                                                                : CAUSTICS_ON;
}

/* What lands of so many; NULL when there is no memory. */
static sure_photon *emit(emission e, uint64_t photons, caustics_statistics *statistics)
{
    e.photons = photons;
    statistics->traced = statistics->landed = 0;
    sure_photon *landed = plan(&e) ? trace(&e, statistics) : NULL;
    for (size_t i = 0; i < e.batch_count; i++)
        free(e.batches[i].landed);
    free(e.batches);
    return landed;
}

/* How many are to leave, after the first: in a picture of n times FEW_PIXELS n^(5/4) times as many
 * as there are to land; 0 where the first will do. */
static uint64_t more_photons(const sure_scene *scene, const caustics_statistics *first)
{
    double larger = (double)scene->width * scene->height / FEW_PIXELS;
    double wanted = fmin(larger * sqrt(sqrt(larger)) * FIRST / 2, LANDED_MOST);
    double share = (double)first->landed / (double)first->traced;
    return larger <= 1 || first->landed == 0 ? 0 : (uint64_t)(wanted / fmax(share, SHARE_LEAST));
}

static sure_photon *emit_enough(const emission *e, caustics_statistics *statistics)
{
    const uint64_t asked = e->settings->photons;
    sure_photon *landed = emit(*e, asked > 0 ? asked : FIRST, statistics);
    uint64_t more = landed && asked == 0 ? more_photons(e->scene, statistics) : 0;
    if (more == 0)
        return landed;
    free(landed);
    return emit(*e, more, statistics);
}

static caustics_state build(const emission *e, caustics_statistics *statistics,
                            sure_photon_map *map)
{
    sure_photon *landed = emit_enough(e, statistics);
    if (!landed)
        return CAUSTICS_NO_MEMORY;
    bool made = statistics->landed > 0 &&
                photon_map_build(landed, statistics->landed, e->scene->object_count,
                                 e->scene->falloff, e->settings->how.threads, map);
    free(landed);
    if (statistics->landed == 0)
        return CAUSTICS_NO_WAY;
    statistics->bytes = made ? photon_map_bytes(map, e->scene->object_count) : 0;
    return made ? CAUSTICS_ON : CAUSTICS_NO_MEMORY;
}

caustics_statistics caustics_build(const sure_scene *scene, const render_settings *settings,
                                   sure_photon_map *map)
{
    caustics_statistics statistics = {.state = need(scene, settings->integrator)};
    const emission e = {.scene = scene, .settings = settings, .power = total_power(scene)};
    if (statistics.state == CAUSTICS_ON)
        statistics.state = build(&e, &statistics, map);
    return statistics;
}

const char *caustics_why(caustics_state state)
{
    static const char *const why[] = {
        [CAUSTICS_ON] = "mirrors or glass light a surface",
        [CAUSTICS_NOT_ASKED] = "another integrator",
        [CAUSTICS_NOT_SHINY] = "no mirror, no glass",
        [CAUSTICS_NOT_FOLLOWED] = "mirrors and glass are not followed (--depth 0)",
        [CAUSTICS_NOT_LIT] = "no light",
        [CAUSTICS_NOT_MATTE] = "no surface to light",
        [CAUSTICS_ENDLESS] = "light that does not fall off; --integrator mixed insists",
        [CAUSTICS_NO_WAY] = "mirrors and glass light no surface",
        [CAUSTICS_NO_MEMORY] = "no memory",
    };
    return why[state];
}

void caustics_print(FILE *out, const caustics_statistics *statistics, double seconds)
{
    fprintf(out, "%-13s %s: %s", "forward pass", statistics->state == CAUSTICS_ON ? "on" : "off",
            caustics_why(statistics->state));
    if (statistics->traced > 0)
        fprintf(out, "; %" PRIu64 " photons towards them, %" PRIu64 " landed, %.2f s",
                statistics->traced, statistics->landed, seconds);
    fputc('\n', out);
}

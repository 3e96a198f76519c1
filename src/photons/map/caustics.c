/* Photons leave each light through those cells of a cube about it in which something shiny may be
 * met, the same number through each cell. */
#include "caustics.h"

#include "../../support/openmp.h"
#include "../power.h"
#include "photon_map_build.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
} batch;

/* Photons that a round traces, at most but for the first batch. */
#define ROUND ((size_t)1 << 17)

typedef struct {
    const sure_scene *scene;
    const caustics_options *options;
    uint64_t photons; /* that are to leave */
    double power;     /* of all lights */
    int cells;
    batch *batches;
    size_t batch_count;
    uint64_t traced;
    sure_photon *landed; /* in the order of their batches */
    size_t landed_count, room;
} emission;

static void mark_face(const emission *e, const sure_object *object, sure_vec3 light, int face,
                      cube *of)
{
    const int axis = face / 8, octant = face % 8;
    sure_mixed_strip column = sure_mixed_strip_of(object, light, axis, octant, 1, e->cells);
    if (column.first > column.last)
        return;
    sure_mixed_strip row = sure_mixed_strip_of(object, light, axis, octant, 2, e->cells);
    for (int j = row.first; j <= row.last; j++) {
        for (int i = column.first; i <= column.last; i++)
            of->active[face][j][i] = true;
    }
}

static void mark(const emission *e, const sure_light *light, cube *of)
{
    const sure_scene *scene = e->scene;
    memset(of, 0, sizeof *of);
    for (size_t i = 0; i < scene->object_count; i++) {
        for (int face = 0; face < FACES && sure_mixed_is_shiny(&scene->materials[i]); face++)
            mark_face(e, &scene->objects[i], light->position, face, of);
    }
}

static size_t count_active(const emission *e, const cube *of)
{
    size_t count = 0;
    for (int face = 0; face < FACES; face++) {
        for (int j = 0; j < e->cells; j++) {
            for (int i = 0; i < e->cells; i++)
                count += of->active[face][j][i];
        }
    }
    return count;
}

/* Of all lights. */
static size_t count_cells(const emission *e, cube *of)
{
    size_t count = 0;
    for (size_t i = 0; i < e->scene->light_count; i++) {
        if (!(power_of(&e->scene->lights[i]) > 0))
            continue;
        mark(e, &e->scene->lights[i], of);
        count += count_active(e, of);
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

static void add_batches(emission *e, size_t light, const cube *of, uint32_t strata)
{
    for (int face = 0; face < FACES; face++) {
        for (int j = 0; j < e->cells; j++) {
            for (int i = 0; i < e->cells; i++) {
                if (!of->active[face][j][i])
                    continue;
                e->batches[e->batch_count++] =
                    (batch){{light, face / 8, face % 8, i, j, e->cells}, strata};
                e->traced += (uint64_t)strata * strata;
            }
        }
    }
}

static void fill_batches(emission *e, cube *of)
{
    const sure_scene *scene = e->scene;
    for (size_t i = 0; i < scene->light_count; i++) {
        const sure_light *light = &scene->lights[i];
        if (!(power_of(light) > 0))
            continue;
        mark(e, light, of);
        size_t active = count_active(e, of);
        if (active > 0)
            add_batches(e, i, of, strata_of(e, light, active));
    }
}

/* Cells as small as there are photons for each. */
static bool plan(emission *e)
{
    cube *of = malloc(sizeof *of);
    if (!of)
        return false;
    size_t count = 0;
    for (e->cells = CELLS_MOST;; e->cells /= 2) {
        count = count_cells(e, of);
        if (count <= e->photons || e->cells == 1)
            break;
    }
    e->batches = malloc((count + 1) * sizeof *e->batches);
    if (e->batches)
        fill_batches(e, of);
    free(of);
    return e->batches != NULL;
}

/* What can't be told from nothing or from everything is left out. */
static bool has_weight(const sure_photon *photon)
{
    double sum = photon->weight.x + photon->weight.y + photon->weight.z;
    return sum > 0 && sum < INFINITY && photon->length < INFINITY;
}

static size_t photons_of(const batch *of)
{
    return (size_t)of->strata * of->strata;
}

static size_t trace_batch(const emission *e, const batch *of, sure_photon *landed)
{
    size_t count = 0;
    for (size_t i = 0; i < photons_of(of); i++) {
        sure_photon photon;
        if (sure_mixed_photon(e->scene, e->options->tier, &of->cell, of->strata, (uint32_t)i,
                              e->options->seed, &photon) &&
            has_weight(&photon))
            landed[count++] = photon;
    }
    return count;
}

/* Batches that are traced at once. */
typedef struct {
    size_t begin, end;
    size_t *first;  /* of each one's photons, among all of these */
    size_t *counts; /* of these: landed */
} turn;

/* Their photons need so much room. */
static size_t take_turn(const emission *e, turn *of)
{
    size_t photons = 0;
    of->begin = of->end;
    while (of->end < e->batch_count) {
        size_t more = photons_of(&e->batches[of->end]);
        if (photons > 0 && photons + more > ROUND)
            break;
        of->first[of->end++ - of->begin] = photons;
        photons += more;
    }
    return photons;
}

static bool make_room(emission *e, size_t photons)
{
    if (e->room - e->landed_count >= photons)
        return true;
    size_t room = e->landed_count + photons + e->room / 2;
    sure_photon *larger = realloc(e->landed, room * sizeof *larger);
    if (!larger)
        return false;
    e->landed = larger;
    e->room = room;
    return true;
}

/* Those that landed behind those of before, in their order. */
static void trace_turn(emission *e, const turn *of)
{
    sure_photon *landed = e->landed + e->landed_count;
    OPENMP(omp parallel for schedule(dynamic) num_threads(openmp_threads(e->options->threads)))
    for (size_t i = of->begin; i < of->end; i++)
        of->counts[i - of->begin] =
            trace_batch(e, &e->batches[i], landed + of->first[i - of->begin]);
    for (size_t i = 0; i < of->end - of->begin; i++) {
        memmove(e->landed + e->landed_count, landed + of->first[i], of->counts[i] * sizeof *landed);
        e->landed_count += of->counts[i];
    }
}

static bool trace(emission *e)
{
    turn of = {.first = malloc((e->batch_count + 1) * sizeof *of.first),
               .counts = malloc((e->batch_count + 1) * sizeof *of.counts)};
    bool done = of.first && of.counts;
    while (done && of.end < e->batch_count) {
        done = make_room(e, take_turn(e, &of));
        if (done)
            trace_turn(e, &of);
    }
    free(of.first);
    free(of.counts);
    return done;
}

static caustics_state need(const sure_scene *scene, bool insists)
{
    bool shiny = false, matte = false, lit = total_power(scene) > 0;
    for (size_t i = 0; i < scene->object_count && !(shiny && matte); i++) {
        shiny = shiny || sure_mixed_is_shiny(&scene->materials[i]);
        matte = matte || sure_mixed_is_matte(&scene->materials[i]);
    }
    if (!shiny || scene->depth < 1)
        return CAUSTICS_NOT_SHINY;
    if (!lit || !matte)
        return !lit ? CAUSTICS_NOT_LIT : CAUSTICS_NOT_MATTE;
    return scene->falloff == SURE_FALLOFF_NONE && !insists ? CAUSTICS_ENDLESS : CAUSTICS_ON;
}

static caustics_state build(emission *e, caustics_statistics *statistics, sure_photon_map *map)
{
    if (!plan(e) || !trace(e))
        return CAUSTICS_NO_MEMORY;
    statistics->traced = e->traced;
    statistics->landed = e->landed_count;
    if (e->landed_count == 0)
        return CAUSTICS_NO_WAY;
    bool made = photon_map_build(e->landed, e->landed_count, e->scene->object_count,
                                 e->scene->falloff, e->options->threads, map);
    return made ? CAUSTICS_ON : CAUSTICS_NO_MEMORY;
}

caustics_statistics caustics_build(const sure_scene *scene, const caustics_options *options,
                                   sure_photon_map *map)
{
    caustics_statistics statistics = {.state = need(scene, options->insists)};
    emission e = {.scene = scene,
                  .options = options,
                  .photons = options->photons > 0 ? options->photons : CAUSTICS_PHOTONS,
                  .power = total_power(scene)};
    if (statistics.state != CAUSTICS_ON)
        return statistics;
    statistics.state = build(&e, &statistics, map);
    free(e.batches);
    free(e.landed);
    return statistics;
}

void caustics_print(FILE *out, const caustics_statistics *statistics)
{
    static const char *const why[] = {
        [CAUSTICS_ON] = "mirrors or glass light a surface",
        [CAUSTICS_NOT_ASKED] = "another integrator",
        [CAUSTICS_NOT_SHINY] = "no mirror, no glass",
        [CAUSTICS_NOT_LIT] = "no light",
        [CAUSTICS_NOT_MATTE] = "no surface to light",
        [CAUSTICS_ENDLESS] = "light that does not fall off; --integrator mixed insists",
        [CAUSTICS_NO_WAY] = "mirrors and glass light no surface",
        [CAUSTICS_NO_MEMORY] = "no memory",
    };
    fprintf(out, "%-13s %s: %s", "forward pass", statistics->state == CAUSTICS_ON ? "on" : "off",
            why[statistics->state]);
    if (statistics->traced > 0)
        fprintf(out, "; %" PRIu64 " photons towards them, %" PRIu64 " landed", statistics->traced,
                statistics->landed);
    fputc('\n', out);
}

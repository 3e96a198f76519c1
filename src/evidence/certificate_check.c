/* SPDX-License-Identifier: MIT */
#include "claim.h"

#include "explain.h"

#include "../hierarchy/bvh_build.h"
#include "../numbers/digits/hex_float.h"
#include "../support/complain.h"
#include "../support/openmp.h"
#include "../scene/placement.h"
#include "../support/progress.h"

#include <inttypes.h>
#include <stdlib.h>

#define SHOWN 10 /* wrong pixels */
#define RUN 256  /* pixels that a thread takes at a time */

typedef struct {
    certificate of;
    const check_options *how;
    rt_scene file;
    sure_scene scene;
    int64_t pixels;
    uint8_t *verdicts;
    int64_t found[CLAIM_VERDICTS]; /* lines of each */
    bool totals_fit;               /* the totals go with one another and with the pixels */
} checking;

static void judge_all(const checking *c)
{
    const int64_t pixels = c->pixels, runs = (pixels + RUN - 1) / RUN;
    progress bar = progress_start(c->how->progress ? stderr : NULL, pixels);
    OPENMP(omp parallel for schedule(dynamic) num_threads(openmp_threads(c->how->threads)))
    for (int64_t run = 0; run < runs; run++) {
        int64_t begin = run * RUN, end = begin + RUN < pixels ? begin + RUN : pixels;
        for (int64_t i = begin; i < end; i++) {
            sure_status seen;
            sure_nearest nearest;
            c->verdicts[i] = (uint8_t)claim_check(&c->scene, &c->of, (size_t)i, &seen, &nearest);
        }
        OPENMP(omp critical)
        progress_step(&bar, end - begin);
    }
    progress_finish(&bar);
}

static void print_answer(const checking *c, sure_status seen, size_t object, int part, double t,
                         double t_error)
{
    if (seen != SURE_HIT) {
        printf("nothing");
        return;
    }
    printf("object %zu (line %zu) %s t %s", object, c->file.elements[object].at.line,
           sure_part_name((sure_part)part), HEX(t));
    if (t_error > 0)
        printf(" +- %s", HEX(t_error));
}

static void print_wrong(const checking *c, size_t i)
{
    const picture_part *part = &c->of.part;
    const pixel_record *claim = &c->of.claims[i].pixel;
    sure_status seen;
    sure_nearest right = {0};
    claim_verdict verdict = claim_check(&c->scene, &c->of, i, &seen, &right);
    printf("pixel %d,%d: certified ", part->x + (int)(i % (size_t)part->width),
           part->y + (int)(i / (size_t)part->width));
    print_answer(c, (sure_status)claim->seen, claim->object, claim->part, claim->t, claim->t_error);
    printf("; exact: ");
    print_answer(c, seen, right.object, (int)right.hit.part, right.hit.t, 0);
    puts(verdict == CLAIM_VAGUE ? "; the error is too large"
         : verdict == CLAIM_RAY ? "; its ray is another one"
                                : "");
}

static void count_verdicts(checking *c)
{
    int shown = 0;
    for (int64_t i = 0; i < c->pixels; i++) {
        c->found[c->verdicts[i]]++;
        if (c->verdicts[i] != CLAIM_RIGHT && shown++ < SHOWN)
            print_wrong(c, (size_t)i);
    }
}

/* A ray of a pixel each, every ray hits or misses, and the pixels' own are among those. Rays go on
 * from up to two places beside a hit: on either side. */
static bool totals_fit(const certificate *of, int64_t pixels)
{
    const sure_statistics *sum = &of->statistics;
    uint64_t hits[SURE_STAGES] = {0}, missed = 0;
    for (int64_t i = 0; i < pixels; i++) {
        missed += of->claims[i].pixel.seen != SURE_HIT;
        hits[of->claims[i].pixel.stage] += of->claims[i].pixel.seen == SURE_HIT;
    }
    bool fit = sum->rays[SURE_RAY_PIXEL] == (uint64_t)pixels && sum->missed >= missed &&
               sum->covered <= sum->origins;
    for (int stage = 0; stage < SURE_STAGES; stage++)
        fit = fit && sum->decided[stage] >= hits[stage];
    const uint64_t all = explain_sum(sum->decided, SURE_STAGES);
    return fit && sum->origins + sum->without_origin <= 2 * all &&
           explain_sum(sum->rays, SURE_RAY_KINDS) == all + sum->missed;
}

static void check_placed(checking *c)
{
    sure_scene *scene = &c->scene;
    sure_bvh bvh = {0};
    if (c->how->quick && bvh_build(scene->objects, scene->object_count, c->how->threads, &bvh))
        scene->bvh = &bvh;
    c->totals_fit = totals_fit(&c->of, c->pixels);
    judge_all(c);
    count_verdicts(c);
    bvh_free(&bvh);
}

#define ANOTHER "not the scene of this certificate: "

/* The certificate's own, by its options. False after a line to standard error, here and below. */
static bool read_scene(const char *path, const certificate *of, rt_scene *file)
{
    rt_bytes bytes;
    bool read = rt_load(path, stderr, &bytes);
    if (read && bytes.hash != of->hash)
        read = complain(stderr, path, ANOTHER "its bytes are others");
    read = read && rt_read_loaded(&bytes, &of->options, RT_SET_ALL, stderr, file);
    free(bytes.text);
    return read;
}

static bool check_scene(checking *c, const char *scene)
{
    const certificate *of = &c->of;
    if (!read_scene(scene, of, &c->file))
        return false;
    bool placed = placement(&c->file, stderr, &c->scene), done = placed;
    c->pixels = (int64_t)of->part.width * of->part.height;
    if (done && c->scene.object_count != json_array_size(of->numbers))
        done = complain(stderr, scene, ANOTHER "it has another number of objects");
    json_t *numbers = done ? certificate_numbers(&c->scene) : NULL;
    if (done && !json_equal(numbers, of->numbers))
        done = complain(stderr, scene, ANOTHER "its objects have other numbers");
    json_decref(numbers);
    if (done && !(c->verdicts = malloc((size_t)c->pixels)))
        done = complain(stderr, scene, "no memory");
    if (done)
        check_placed(c);
    free(c->verdicts);
    if (placed)
        placement_free(&c->scene);
    rt_scene_free(&c->file);
    return done;
}

/* Is all right? */
static bool print_result(const checking *c, const char *path)
{
    static const char *const words[CLAIM_VERDICTS] = {
        [CLAIM_RAY] = "another ray",   [CLAIM_OBJECT] = "another object",
        [CLAIM_PART] = "another part", [CLAIM_T] = "t off",
        [CLAIM_VAGUE] = "t too vague",
    };
    const int64_t wrong = c->pixels - c->found[CLAIM_RIGHT];
    const uint64_t acne = c->of.statistics.acne;
    bool right = wrong == 0 && acne == 0 && c->totals_fit;
    if (right && c->how->quiet)
        return true;
    printable_printf(stdout, "%s: %" PRId64 " pixels, ", path, c->pixels);
    if (wrong == 0)
        printf("all right");
    else
        printf("%" PRId64 " wrong:", wrong);
    const char *between = " ";
    for (int verdict = CLAIM_RIGHT + 1; verdict < CLAIM_VERDICTS; verdict++) {
        if (c->found[verdict] == 0)
            continue;
        printf("%s%s %" PRId64, between, words[verdict], c->found[verdict]);
        between = ", ";
    }
    if (acne > 0)
        printf("; acne %" PRIu64, acne);
    puts(c->totals_fit ? "" : "; the totals don't fit the pixels");
    return right;
}

int certificate_check(const char *path, const char *scene, const check_options *options)
{
    checking c = {.how = options};
    if (!certificate_read(path, &c.of))
        return 2;
    int status = !check_scene(&c, scene) ? 2 : print_result(&c, path) ? 0 : 1;
    certificate_free(&c.of);
    return status;
}

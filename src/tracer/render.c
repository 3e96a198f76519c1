#include "render.h"
#include "progress.h"

#include <math.h>
#include <surehit/backward.h>

#ifdef _OPENMP
#include <omp.h>
#define OPENMP(directive) _Pragma(#directive)
#else
#define OPENMP(directive)
#endif

/* Pixels that a thread takes at a time: runs in reading order share the work evenly whatever the
 * picture's shape, and one run is long beside the cost of taking it. */
#define RUN 256

/* Not a number becomes black. */
static uint8_t to_byte(double linear)
{
    if (!(linear > 0))
        return 0;
    return linear < 1 ? (uint8_t)lround(255 * linear) : 255;
}

static void render_run(const sure_scene *scene, sure_tier tier, int64_t begin, int64_t end,
                       uint8_t *rgb)
{
    for (int64_t i = begin; i < end; i++) {
        int column = (int)(i % scene->width), row_from_top = (int)(i / scene->width);
        sure_vec3 color =
            sure_backward_pixel(scene, tier, column, scene->height - 1 - row_from_top);
        rgb[3 * i] = to_byte(color.x);
        rgb[3 * i + 1] = to_byte(color.y);
        rgb[3 * i + 2] = to_byte(color.z);
    }
}

void render(const sure_scene *scene, const render_options *options, picture *image)
{
    const int64_t pixels = (int64_t)scene->width * scene->height;
    const int64_t runs = (pixels + RUN - 1) / RUN;
    progress bar = progress_start(stderr, pixels);
#ifdef _OPENMP
    const int threads = options->threads > 0 ? options->threads : omp_get_num_procs();
#endif
    OPENMP(omp parallel for schedule(dynamic) num_threads(threads))
    for (int64_t run = 0; run < runs; run++) {
        int64_t begin = run * RUN, end = begin + RUN < pixels ? begin + RUN : pixels;
        render_run(scene, options->tier, begin, end, image->rgb);
        if (options->progress) {
            OPENMP(omp critical)
            progress_step(&bar, end - begin);
        }
    }
    progress_finish(&bar);
}

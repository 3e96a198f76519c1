/* What the tier stable answers where the first stage of the disc is uncertain: as textbook has it,
 * but for what is certain on which side of the rim the crossing lies. */
#include "../stable.h"
#include "disc.h"
#include "disc_filter.h"

static span disc_guess(const sure_ray *ray, const void *shape)
{
    const sure_disc *disc = shape;
    filter_interval unused;
    filter_verdict verdict = disc_filter(ray, disc, &unused);
    plane_line line = plane_line_from(ray, disc->centre, disc->normal);
    return verdict == FILTER_INTERVAL ? plane_line_span(&line)
           : verdict == FILTER_MISS   ? span_empty()
                                      : disc_line_span(&line, (real)disc->radius);
}

STABLE_QUESTIONS(disc)

/* The filters of cylinder and cone once more, with numbers of twice the digits: where an end of the
 * wall is too near a rim for doubles, or its t not near enough. */
#ifndef SHAPES_AXIAL_CLOSE_H
#define SHAPES_AXIAL_CLOSE_H

#include "../cone/cone_filter.h"
#include "../cylinder/cylinder_filter.h"

/* As cylinder_filter and cone_filter, with a D that is known and above 0. Entry: round to nearest;
 * what the filters' scales take;
 * of: the filter's terms. */
filter_verdict cylinder_close(const sure_ray *ray, const sure_cylinder *cylinder,
                              const cylinder_terms *of, const quarter *known, filter_chord *found);
filter_verdict cone_close(const sure_ray *ray, const sure_cone *cone, const cone_terms *of,
                          const quarter *known, filter_chord *found);

#endif

/* The stages of bounded range: an answer by name, and the t that belongs to the names as nearly as
 * the stage knows it. Round to nearest is required. */
#ifndef STAGES_SOLVE_H
#define STAGES_SOLVE_H

#include "../numbers/near.h"
#include "../shapes/chord.h"

#include <surehit/object.h>

/* What was found, certainly; t says by its error how well it is known (a NaN for not at all). */
typedef struct {
    sure_status status;
    chord_end end;
    near t;
} solved_hit;

typedef struct {
    sure_status status;
    chord ends;
    near t_enter, t_leave;
} solved_interval;

/* False when the stage can't tell. Entry: what question_of made. */
bool solve_hit_near(const sure_ray *ray, const sure_object *object, solved_hit *found);
bool solve_hit_residue(const sure_ray *ray, const sure_object *object, solved_hit *found);
bool solve_interval_near(const sure_ray *ray, const sure_object *object, solved_interval *found);
bool solve_interval_residue(const sure_ray *ray, const sure_object *object, solved_interval *found);

#endif

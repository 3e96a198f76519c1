/* Which shapes and regimes were asked for: --shape and --regime, given as often as one likes. */
#ifndef CLI_CHOICE_H
#define CLI_CHOICE_H

#include "args.h"

#include "../cases/regimes.h"

typedef struct {
    bool shapes[SURE_SHAPES], regimes[REGIMES];
    bool some_shapes, some_regimes; /* none asked for is all */
} choice;

/* Return the exit status, 0 to go on. */
int choice_add_shape(const args *line, const char *value, choice *asked);
int choice_add_regime(const args *line, const char *value, choice *asked);

/* Is the pair asked for, and does the regime mean anything for the shape? */
bool choice_has(const choice *asked, int shape, int which);

/* The regimes' names, for a help text. */
void choice_print_regimes(void);

#endif

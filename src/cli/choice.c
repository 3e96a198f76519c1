#include "choice.h"

#include <stdio.h>

int choice_add_shape(const args *line, const char *value, choice *asked)
{
    sure_shape shape;
    if (!sure_shape_from_name(value, &shape))
        return args_wrong_value(line, "--shape", value, "plane, disc, sphere, cylinder or cone");
    asked->shapes[shape] = asked->some_shapes = true;
    return 0;
}

int choice_add_regime(const args *line, const char *value, choice *asked)
{
    regime which;
    if (!regime_from_name(value, &which))
        return args_wrong_value(line, "--regime", value, "one of the regimes");
    asked->regimes[which] = asked->some_regimes = true;
    return 0;
}

bool choice_has(const choice *asked, int shape, int which)
{
    return (asked->shapes[shape] || !asked->some_shapes) &&
           (asked->regimes[which] || !asked->some_regimes) &&
           regime_applies((sure_shape)shape, (regime)which) != 0;
}

void choice_print_regimes(void)
{
    int column = 80;
    fputs("\nRegimes:", stdout);
    for (int i = 0; i < REGIMES; i++) {
        const char *name = regime_name((regime)i);
        int length = snprintf(NULL, 0, " %s", name);
        if (column + length > 78) {
            fputs("\n    ", stdout);
            column = 4;
        }
        printf(" %s", name);
        column += length;
    }
    putchar('\n');
}

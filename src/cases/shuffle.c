#include "shuffle.h"

void shuffle(sure_case *cases, int count, rng *g)
{
    for (int i = count - 1; i > 0; i--) {
        int other = rng_integer(g, 0, i);
        sure_case moved = cases[i];
        cases[i] = cases[other];
        cases[other] = moved;
    }
}

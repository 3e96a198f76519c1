/* SPDX-License-Identifier: MIT */
/* The worst that roundings can do, to first order. Every operation of a first stage is recorded,
 * with what it is made of. From a result back through these steps (its adjoint), what one rounding
 * changes is known for each of them. The sum of these, all of 2^-52 and of the worst sign, is what
 * the result may be off by. Uphill from hostile rays, over the published bound, it must come to
 * between 0.1 and 1: above, the bound is wrong; below, it is a bound of something else. */
#include "claims.hpp"
#include "hostile.hpp"

#include <stdio.h>
#include <string.h>

static double share_of(const claim &which, const double x[])
{
    case_of c;
    c.q = recorded(which.shape, x);
    c.verdict = filtered(c.q, &c.found);
    return which.share(c);
}

/* From where the query stands, some of its numbers at a time. */
static double climb(const claim &which, hostile *draw, int steps, double x[])
{
    double best = share_of(which, x), y[INPUTS];
    for (int i = 0; i < steps && best >= 0; i++) {
        memcpy(y, x, sizeof y);
        double stride = draw->power(-52, 1);
        for (int changes = 1 + draw->among(4); changes > 0; changes--) {
            int at = draw->among(T_MAX);
            y[at] += stride * draw->between(-1, 1) * (draw->among(2) ? y[at] : 1);
        }
        double found = share_of(which, y);
        if (found > best) {
            best = found;
            memcpy(x, y, sizeof y);
        }
    }
    return best;
}

/* The greatest share found, and where. */
static double uphill(const claim &which, int climbs, double place[])
{
    hostile draw(7);
    double worst = 0, x[INPUTS];
    for (int i = 0; i < climbs; i++) {
        int tries = 100;
        do {
            draw.query(which.shape, 0, 52, x);
        } while (share_of(which, x) < 0 && --tries > 0);
        double best = climb(which, &draw, 4000, x);
        if (best > worst) {
            worst = best;
            memcpy(place, x, sizeof x);
        }
    }
    return worst;
}

int main(int count, char **arguments)
{
    int climbs = count > 1 ? atoi(arguments[1]) : 40;
    bool all_good = true;
    setvbuf(stdout, nullptr, _IOLBF, 0);
    for (const claim &which : CLAIMS) {
        double x[INPUTS] = {0}, worst = uphill(which, climbs, x);
        bool good = worst > which.least && worst <= 1;
        printf("%-34s %.3f\n", which.name, worst);
        if (!good) {
            printf("%s:%d:F:%s: %s:", __FILE__, __LINE__, which.name,
                   worst > 1 ? "above 1" : "next to nothing");
            for (double scalar : x)
                printf(" %a", scalar);
            printf("\n");
        }
        all_good = all_good && good;
    }
    printf(all_good ? "1 passed, 0 failed\n" : "0 passed, 1 failed\n");
    return all_good ? 0 : 1;
}

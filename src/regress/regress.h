/* A scene held against its golden picture: the one that its user has looked at and found right. */
#ifndef REGRESS_REGRESS_H
#define REGRESS_REGRESS_H

#include "../image/difference.h"
#include "../photons/render_file.h"

typedef enum {
    REGRESS_SAME,
    REGRESS_DIFFERS,
    REGRESS_NEW,        /* no golden picture yet */
    REGRESS_STALE,      /* a golden picture without a scene */
    REGRESS_BAD_SCENE,  /* the scene can't be read */
    REGRESS_BAD_GOLDEN, /* the golden picture can't */
    REGRESS_VERDICTS
} regress_verdict;

typedef struct {
    regress_verdict verdict;
    difference apart;    /* from the golden picture to what is drawn now; REGRESS_DIFFERS */
    picture golden, got; /* rgb is NULL where there is none */
    char *messages;      /* errors and warnings of the readers, a line each; "" for none */
} regression;

/* Reads `golden`, which need not be there, and draws `scene`; for a stale picture `scene` is NULL.
 * False when there is no memory, and nothing is left allocated; else free it with regress_free. */
bool regress(const char *scene, const char *golden, const render_settings *settings,
             regression *found);
void regress_free(regression *found);

/* "differs: 12 of 57600 pixels, ...": what a line about it says behind the scene's name. */
void regress_print_verdict(FILE *out, const regression *found);

/* "3 scenes: 1 same, 1 different, 1 new; 1 stale golden picture". */
void regress_print_counts(FILE *out, const int counts[REGRESS_VERDICTS]);

#endif

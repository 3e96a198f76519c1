/* A folder of scenes held against its golden pictures. */
#ifndef REGRESS_REGRESS_FOLDER_H
#define REGRESS_REGRESS_FOLDER_H

#include "../photons/render_file.h"

typedef struct {
    const char *folder; /* of scenes, *.rt */
    const char *golden; /* the folder of golden pictures, *.png; NULL: FOLDER/golden */
    const char *page;   /* the path of a page that shows what differs, or NULL */
    bool accept;        /* what is drawn now becomes golden */
    bool quiet;         /* no word of what is the same */
    render_settings settings;
} regress_plan;

typedef enum {
    REGRESSED_SAME,   /* or accepted */
    REGRESSED_LEFT,   /* something differs, is new or stale */
    REGRESSED_TROUBLE /* something could not be read or written */
} regress_outcome;

/* Tells of every scene on standard output, of trouble on standard error. */
regress_outcome regress_folder(const regress_plan *plan);

#endif

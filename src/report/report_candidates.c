#define _XOPEN_SOURCE 700 /* realpath, strndup */

#include "report.h"

#include "../support/folder.h"

#include <stdlib.h>
#include <string.h>

/* Seen from the program, where both were built. */
#define PEERS_FOLDER "../../reference/peers"
#define PEER_BEGIN "libpeer-"
#define PEER_END ".so"

/* The file's name without what every such name has: libpeer-kahan.so is kahan. It lives as long as
 * the program. */
static const char *short_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    if (strncmp(name, PEER_BEGIN, strlen(PEER_BEGIN)) == 0)
        name += strlen(PEER_BEGIN);
    else if (strncmp(name, "lib", 3) == 0)
        name += 3;
    return strndup(name, strcspn(name, "."));
}

bool report_add(report_run *run, sure_tier tier, const char *library)
{
    report_candidate *who = &run->list[run->count++];
    *who = (report_candidate){.name = library ? short_name(library) : sure_tier_name(tier),
                              .library = library,
                              .tier = tier};
    return who->name != NULL;
}

bool report_choose_all(report_run *run)
{
    char way[4096];
    folder_listing found;
    for (int tier = 0; tier < SURE_TIERS; tier++)
        report_add(run, (sure_tier)tier, NULL);
    char *folder = folder_from_program(PEERS_FOLDER, way, sizeof way) ? realpath(way, NULL) : NULL;
    if (!folder)
        return true;
    bool done = true;
    folder_list(folder, PEER_BEGIN, PEER_END, NULL, &found);
    for (int i = 0; done && i < found.count && run->count < REPORT_CANDIDATES; i++) {
        char *path = folder_path(folder, found.names[i], strlen(found.names[i]), "");
        done = path && report_add(run, 0, path);
    }
    folder_free(&found);
    free(folder);
    return done;
}

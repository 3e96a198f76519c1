#define _DEFAULT_SOURCE /* scandir, readlink */

#include "report_run.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Seen from the program, where both were built. */
#define PEERS_FOLDER "../../reference/peers/"
#define PEER_BEGIN "libpeer-"
#define PEER_END ".so"

static report_candidate *add(report_run *run)
{
    report_candidate *who = &run->list[run->count++];
    memset(who, 0, sizeof *who);
    return who;
}

void report_add_tier(report_run *run, sure_tier tier)
{
    report_candidate *who = add(run);
    who->name = sure_tier_name(tier);
    who->tier = tier;
}

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

bool report_add_library(report_run *run, const char *path)
{
    report_candidate *who = add(run);
    who->name = short_name(path);
    who->library = path;
    return who->name != NULL;
}

static int is_peer(const struct dirent *entry)
{
    size_t length = strlen(entry->d_name), end = strlen(PEER_END);
    return strncmp(entry->d_name, PEER_BEGIN, strlen(PEER_BEGIN)) == 0 && length > end &&
           strcmp(entry->d_name + length - end, PEER_END) == 0;
}

/* The folder, with its slash; false: there is none. */
static bool find_peers(char *folder, size_t size)
{
    ssize_t length = readlink("/proc/self/exe", folder, size - sizeof PEERS_FOLDER);
    if (length <= 0)
        return false;
    folder[length] = '\0';
    char *slash = strrchr(folder, '/');
    strcpy(slash ? slash + 1 : folder, PEERS_FOLDER);
    char *real = realpath(folder, NULL);
    bool found = real && strlen(real) + 2 <= size;
    if (found)
        sprintf(folder, "%s/", real);
    free(real);
    return found;
}

static bool add_peers(report_run *run)
{
    char folder[4096];
    struct dirent **entries;
    int found =
        find_peers(folder, sizeof folder) ? scandir(folder, &entries, is_peer, alphasort) : 0;
    bool done = true;
    for (int i = 0; i < found; i++) {
        size_t size = strlen(folder) + strlen(entries[i]->d_name) + 1;
        char *path = run->count < REPORT_CANDIDATES ? malloc(size) : NULL;
        if (path) {
            snprintf(path, size, "%s%s", folder, entries[i]->d_name);
            done = report_add_library(run, path) && done;
        }
        free(entries[i]);
    }
    if (found > 0)
        free(entries);
    return done;
}

bool report_choose_all(report_run *run)
{
    for (int tier = 0; tier < SURE_TIERS; tier++)
        report_add_tier(run, (sure_tier)tier);
    return add_peers(run);
}
